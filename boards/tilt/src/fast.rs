//! Copies the code that `fast.x` places in RAM.
#![allow(unsafe_code, reason = "nothing written in Rust may run before RAM holds what it should")]

use core::arch::global_asm;

// `cortex-m-rt` calls this before it initialises statics; r0 to r3 may be overwritten
global_asm!(
    ".section .text.__pre_init, \"ax\"",
    ".global __pre_init",
    ".type __pre_init, %function",
    ".thumb_func",
    "__pre_init:",
    "ldr r0, =__fasttext_start",
    "ldr r1, =__fasttext_end",
    "ldr r2, =__fasttext_source",
    "b 2f",
    "1: ldm r2!, {{r3}}",
    "stm r0!, {{r3}}",
    "2: cmp r0, r1",
    "blo 1b",
    "bx lr",
    ".pool",
    ".size __pre_init, . - __pre_init",
);
