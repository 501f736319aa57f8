//! a mesh has 2·(W − 1)·(H − 1) triangles

use kerchief::Mesh;

fn main() {
    let _: [[u16; 3]; 8] = Mesh::<4, 4>::indices();
}
