//! What a fixed-point firmware must not contain, and what its step must not call.

use crate::image::Image;

/// Number types that are floats: a chip without a unit for them calls routines.
const FLOATS: [&str; 2] = ["f32", "f64"];

/// Checks a program that does nothing but move a sheet, and returns what its step calls that a fast step would not, joined.
pub(crate) fn check(image: &Image, number: &str, scene: &str) -> String {
    let allocator = image.names().find(|name| name.contains("alloc::"));
    assert_eq!(allocator, None, "{scene} in {number}: something allocates");
    if FLOATS.contains(&number) {
        return String::new();
    }
    let float = image.names().find(|name| is_float(name));
    assert_eq!(float, None, "{scene} in {number}: a fixed-point firmware has no use for floats");
    let mut calls = image.reached("footprint::frame");
    calls.retain(|name, _| is_slow(name) || is_panic(name));
    for way in calls.values() {
        // shown where the test fails
        println!("{scene} in {number}: {way}");
    }
    calls.into_keys().collect::<Vec<_>>().join(" ")
}

/// Run-time ABI for the Arm Architecture, 4.1: the floating-point helpers; and the names of their bodies.
fn is_float(name: &str) -> bool {
    name.starts_with("__aeabi_f")
        || name.starts_with("__aeabi_d")
        || ["__aeabi_i2f", "__aeabi_ui2f", "__aeabi_l2f", "__aeabi_ul2f"].contains(&name)
        || name.starts_with("compiler_builtins::float")
}

/// Products of 64 bits and divisions, as calls (Run-time ABI, 4.2 and 4.3).
fn is_slow(name: &str) -> bool {
    name.starts_with("__aeabi_") && (name.contains("div") || name.contains("mul"))
        || ["__divmoddi4", "__udivmoddi4", "__divti3", "__udivti3", "__multi3"].contains(&name)
}

fn is_panic(name: &str) -> bool {
    name.starts_with("core::panicking") || name.contains("panic_")
}
