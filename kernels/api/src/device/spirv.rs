//! rust-gpu's machine: spirv-std. Type-checked against spirv-std 0.11, not run (it takes rust-gpu's toolchain).

use spirv_std::arch;

/// By halves: rust-gpu's own way is a 64-bit product, which not every device has.
#[inline]
pub fn mul_high(a: u32, b: u32) -> u32 {
    let (a_high, a_low, b_high, b_low) = (a >> 16, a & 0xffff, b >> 16, b & 0xffff);
    let low = a_low * b_low;
    let middle = a_high * b_low + (low >> 16);
    let carry = a_low * b_high + (middle & 0xffff);
    a_high * b_high + (middle >> 16) + (carry >> 16)
}

#[inline]
pub fn sqrt(a: f32) -> f32 {
    spirv_std::num_traits::Float::sqrt(a)
}

#[inline]
pub fn fma(a: f32, b: f32, c: f32) -> f32 {
    spirv_std::num_traits::Float::mul_add(a, b, c)
}

#[inline]
pub fn barrier() {
    arch::workgroup_memory_barrier_with_group_sync()
}

/// rust-gpu knows the built-in as an entry point's parameter only: counted, which is right where all invocations are active.
#[inline]
pub fn subgroup_size() -> u32 {
    arch::subgroup_i_add(1u32)
}

/// As for [`subgroup_size`].
#[inline]
pub fn subgroup_lane() -> u32 {
    arch::subgroup_exclusive_i_add(1u32)
}

#[inline]
pub fn subgroup_add(value: u32) -> u32 {
    arch::subgroup_i_add(value)
}

#[inline]
pub fn subgroup_min(value: u32) -> u32 {
    arch::subgroup_u_min(value)
}

#[inline]
pub fn subgroup_max(value: u32) -> u32 {
    arch::subgroup_u_max(value)
}

#[inline]
pub fn subgroup_any(value: bool) -> bool {
    arch::subgroup_any(value)
}

#[inline]
pub fn subgroup_all(value: bool) -> bool {
    arch::subgroup_all(value)
}

#[inline]
pub fn subgroup_read(value: u32, lane: u32) -> u32 {
    arch::subgroup_shuffle(value, lane)
}

#[inline]
pub fn subgroup_count(value: bool) -> u32 {
    arch::subgroup_ballot_bit_count(arch::subgroup_ballot(value))
}
