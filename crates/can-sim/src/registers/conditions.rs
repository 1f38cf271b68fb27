//! Conditions of the description, evaluated over the registers.

use regbus::meta::{Expr, Field, FieldRef, Index};

use super::{FieldAt, RegisterFile, Slot};

impl RegisterFile {
    /// Whether a condition of the description holds. `own` is the manual's number of the element or lane that asks, for
    /// conditions with `[n]`.
    #[must_use]
    pub fn holds(&self, condition: u16, own: Option<u32>) -> bool {
        self.expression_holds(&self.meta.conditions[condition as usize].expr, own)
    }

    pub(super) fn expression_holds(&self, expr: &Expr, own: Option<u32>) -> bool {
        match *expr {
            Expr::Always => true,
            Expr::Compare { field, index, comparison, value } => {
                self.numbered(field, index, own).is_some_and(|at| comparison.holds(self.field(at), value))
            }
            Expr::Word { .. } => false,
            Expr::Not(inner) => !self.expression_holds(inner, own),
            Expr::All(of) => of.iter().all(|expr| self.expression_holds(expr, own)),
            Expr::Any(of) => of.iter().any(|expr| self.expression_holds(expr, own)),
        }
    }

    /// The lane or element of a field that an index means; `None` if there is none with that number.
    pub(super) fn numbered(&self, field: FieldRef, index: Index, own: Option<u32>) -> Option<FieldAt> {
        let info = &self.meta.registers[field.register as usize];
        let of = self.field_info(field);
        let number = match (index, info.cluster, own) {
            // Without a number a field of a cluster is that of the element that asks.
            (Index::Single, Some(_), Some(own)) => own,
            (Index::Single, ..) => return Some(self.field_at(field)),
            (Index::Own, ..) => own?,
            (Index::Fixed(number), ..) => number,
        };
        let (element, inner, lane) = if of.lanes > 1 {
            let index = number.checked_sub(u32::from(of.first_lane))?;
            (0, index / u32::from(of.lanes), index % u32::from(of.lanes))
        } else if let Some(cluster) = info.cluster {
            (number.checked_sub(cluster.first)?, 0, 0)
        } else if let Some(array) = info.array {
            (0, number.checked_sub(array.first)?, 0)
        } else {
            (0, 0, 0)
        };
        let slot = self.slot_of(field.register, element, inner)?;
        Some(self.at(slot, of, lane as u8))
    }

    /// The manual's number of a lane of a field in a register: what `[n]` stands for in its conditions.
    pub(super) fn own_number(&self, slot: Slot, field: &Field, lane: u8) -> Option<u32> {
        let at = self.physical[slot.0 as usize];
        let info = self.info(slot);
        if field.lanes > 1 {
            return Some(u32::from(field.first_lane) + u32::from(lane) + u32::from(field.lanes) * at.inner);
        }
        let cluster = info.cluster.map(|cluster| cluster.first + at.element);
        cluster.or(info.array.map(|array| array.first + at.inner))
    }
}

/// The first field with an own number in an expression.
pub(super) fn own_field(expr: &Expr) -> Option<FieldRef> {
    match *expr {
        Expr::Compare { field, index: Index::Own, .. } => Some(field),
        Expr::Not(inner) => own_field(inner),
        Expr::All(of) | Expr::Any(of) => of.iter().find_map(own_field),
        Expr::Always | Expr::Compare { .. } | Expr::Word { .. } => None,
    }
}

/// Every field in an expression, with its index.
pub(super) fn fields(expr: &Expr, found: &mut Vec<(FieldRef, Index)>) {
    match *expr {
        Expr::Compare { field, index, .. } => found.push((field, index)),
        Expr::Not(inner) => fields(inner, found),
        Expr::All(of) | Expr::Any(of) => of.iter().for_each(|expr| fields(expr, found)),
        Expr::Always | Expr::Word { .. } => {}
    }
}
