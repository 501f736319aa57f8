//! Plays a scene file of arbitrary bytes.
#![no_main]

kerchief::simulations! {
    /// All grids that are small enough to be played.
    fn simulation;
    scalars: F32 = f32, F64 = f64, Q24 = kerchief::Q24, Q13 = kerchief::Q13;
    grids: (1, 32) (4, 4) (8, 8)
}

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| kerchief_fuzz::file::play(bytes, simulation));
