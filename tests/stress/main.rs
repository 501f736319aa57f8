//! Stress tests: in every run a sheet stays finite and bounded, moves the same way twice, causes no panic, and settles afterwards.

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

/// Whether this is the long tier (`KERCHIEF_LONG=1`, optimised). Each test that is larger there says so.
fn is_long() -> bool {
    std::env::var_os("KERCHIEF_LONG").is_some()
}
