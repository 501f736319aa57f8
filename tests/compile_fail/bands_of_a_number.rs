//! expected `Width`, found integer

use kerchief::render::pattern::Stripes;

fn main() {
    let _ = Stripes { width: 2, tones: [Default::default(); 2] };
}
