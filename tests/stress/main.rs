//! What sheets must survive: in every run finite, bounded, the same twice, without a panic, and afterwards they settle.

mod day;
mod elasticity;
mod far_colliders;
mod far_links;
mod gale;
mod hands;
mod heavy_border;
mod heavy_limit;
mod heavy_pair;
mod held_row;
mod laid;
mod large_triangles;
mod light_border;
mod light_row;
mod materials;
mod ordeal;
mod random_sheets;
mod soft_springs;
mod stage;
mod starts;
mod thick_air;
mod torn_chains;

/// Whether the long tier asks (`KERCHIEF_LONG=1`, optimised): each test that is then larger says by what.
fn is_long() -> bool {
    std::env::var_os("KERCHIEF_LONG").is_some()
}
