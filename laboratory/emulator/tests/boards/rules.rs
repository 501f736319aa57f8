//! Functions that fixed-point firmware must not contain, and functions that its step must not call.

use crate::image::Image;

/// Floating-point types: a chip without a unit for them calls routines.
const FLOATS: [&str; 2] = ["f32", "f64"];

/// Checks a program that only moves a sheet. It contains no allocator and, in fixed point, no routine for floats. A step in fixed point reaches no routine
/// for divisions or 64-bit products, and no panic.
pub(crate) fn check(image: &Image, number: &str, scene: &str) {
    let allocator = image.names().find(|name| name.contains("alloc::"));
    assert_eq!(allocator, None, "{scene} in {number}: something allocates");
    if FLOATS.contains(&number) {
        return;
    }
    let float = image.names().find(|name| is_float(name));
    assert_eq!(float, None, "{scene} in {number}: a fixed-point firmware has no use for floats");
    for (name, way) in &image.reached("footprint::frame") {
        assert!(!is_panic(name), "{scene} in {number}: a step that cannot fail calls {name}: {way}");
        assert!(!is_division(name), "{scene} in {number}: divisions are products with reciprocals: {way}");
        assert!(!is_product(name), "{scene} in {number}: 64-bit products are put together from halves: {way}");
    }
}

/// Floating-point helpers (Run-time ABI for the Arm Architecture, 4.1) and the functions that implement them.
fn is_float(name: &str) -> bool {
    name.starts_with("__aeabi_f")
        || name.starts_with("__aeabi_d")
        || ["__aeabi_i2f", "__aeabi_ui2f", "__aeabi_l2f", "__aeabi_ul2f"].contains(&name)
        || name.starts_with("compiler_builtins::float")
}

/// Routines that divide (Run-time ABI, 4.2 and 4.3).
fn is_division(name: &str) -> bool {
    name.starts_with("__aeabi_") && name.contains("div") || name.contains("div_rem") || name.contains("divmod")
}

/// Routines for 64-bit products (Run-time ABI, 4.2).
fn is_product(name: &str) -> bool {
    ["__aeabi_lmul", "__multi3"].contains(&name)
}

fn is_panic(name: &str) -> bool {
    name.starts_with("core::panicking") || name.contains("panic_")
}
