//! Which node acts next: a winner tree over the nodes' next keys, so that a change costs a logarithm of the nodes.

#[derive(Clone, Debug, Default)]
pub(crate) struct Schedule {
    keys: Vec<u64>,
    /// Heap-ordered: entry 1 is the root; the leaves are the nodes themselves.
    winners: Vec<u16>,
    leaves: usize,
}

const NEVER: u64 = u64::MAX;
/// Up to so many nodes are looked through one by one, which is faster than keeping the tree.
const FEW: usize = 4;

impl Schedule {
    /// Makes room for one more node.
    pub(crate) fn push(&mut self) {
        self.keys.push(NEVER);
        self.leaves = self.keys.len().next_power_of_two();
        self.winners = vec![0; self.leaves.max(1)];
        for node in (0..self.leaves).rev() {
            self.replay(node);
        }
    }

    fn key(&self, node: u16) -> u64 {
        self.keys.get(usize::from(node)).copied().unwrap_or(NEVER)
    }

    fn entry(&self, at: usize) -> u16 {
        if at >= self.leaves {
            (at - self.leaves) as u16
        } else {
            self.winners[at]
        }
    }

    fn replay(&mut self, node: usize) {
        let mut at = (node + self.leaves) >> 1;
        while at >= 1 {
            let (left, right) = (self.entry(2 * at), self.entry(2 * at + 1));
            self.winners[at] = if self.key(right) < self.key(left) {
                right
            } else {
                left
            };
            at >>= 1;
        }
    }

    #[inline]
    pub(crate) fn set(&mut self, node: usize, key: u64) {
        if self.keys[node] != key {
            self.keys[node] = key;
            if self.leaves > FEW {
                self.replay(node);
            }
        }
    }

    /// The smallest key and its node, the lower number first among equals.
    #[inline]
    pub(crate) fn first(&self) -> Option<(u64, usize)> {
        if let [a, b] = self.keys[..] {
            let first = if b < a { (b, 1) } else { (a, 0) };
            return (first.0 != NEVER).then_some(first);
        }
        if self.leaves <= FEW {
            let mut first = (NEVER, 0);
            for (node, key) in self.keys.iter().enumerate() {
                if *key < first.0 {
                    first = (*key, node);
                }
            }
            return (first.0 != NEVER).then_some(first);
        }
        let node = self.winners[1];
        let key = self.key(node);
        (key != NEVER).then_some((key, usize::from(node)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_key_wins_and_the_lower_node_among_equals() {
        for nodes in 1..20 {
            let mut schedule = Schedule::default();
            for _ in 0..nodes {
                schedule.push();
            }
            assert_eq!(schedule.first(), None);
            let mut keys = vec![NEVER; nodes];
            let mut state = 12345u64;
            for _ in 0..500 {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                let node = (state >> 33) as usize % nodes;
                let key = if state >> 60 == 0 {
                    NEVER
                } else {
                    state >> 40 & 0xF
                };
                keys[node] = key;
                schedule.set(node, key);
                let expected = keys
                    .iter()
                    .copied()
                    .enumerate()
                    .map(|(n, k)| (k, n))
                    .min()
                    .filter(|(k, _)| *k != NEVER);
                assert_eq!(schedule.first(), expected);
            }
        }
    }
}
