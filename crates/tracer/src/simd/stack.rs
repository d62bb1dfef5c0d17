//! `Stack`: what a walk has still to visit, without the time that clearing an
//! array would take for each ray.
#![allow(unsafe_code)]

use std::mem::MaybeUninit;

/// Memory for a [`Stack`], not written before it is used.
pub(crate) struct Room<T, const CAPACITY: usize>([MaybeUninit<T>; CAPACITY]);

impl<T: Copy, const CAPACITY: usize> Room<T, CAPACITY> {
    /// Room for so many entries.
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self([const { MaybeUninit::uninit() }; CAPACITY])
    }

    /// An empty stack that is kept here.
    #[inline(always)]
    pub(crate) fn stack(&mut self) -> Stack<'_, T> {
        Stack { entries: &mut self.0, len: 0 }
    }
}

/// A stack of a fixed capacity.
pub(crate) struct Stack<'a, T> {
    entries: &'a mut [MaybeUninit<T>],
    /// The first so many entries were written.
    len: usize,
}

impl<T: Copy> Stack<'_, T> {
    /// How many entries it has.
    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// Puts one on top.
    ///
    /// # Panics
    /// Where it is full, which the depth of a hierarchy rules out.
    #[inline(always)]
    pub(crate) fn push(&mut self, entry: T) {
        self.entries[self.len].write(entry);
        self.len += 1;
    }

    /// Takes the top one.
    #[inline(always)]
    pub(crate) fn pop(&mut self) -> Option<T> {
        if self.len == 0 {
            return None;
        }
        self.len -= 1;
        // SAFETY: `push` has written the first `len` entries, and this was one
        // of them.
        Some(unsafe { self.entries.get_unchecked(self.len).assume_init() })
    }

    /// The entries from place `first` on, the lowest first.
    #[inline(always)]
    pub(crate) fn from(&mut self, first: usize) -> &mut [T] {
        let entries = &mut self.entries[first..self.len];
        // SAFETY: `push` has written the first `len` entries.
        unsafe { entries.assume_init_mut() }
    }
}
