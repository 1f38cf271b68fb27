//! Fields.

use indexmap::IndexMap;

use super::Lowering;
use super::references::{cites, weight};
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{
    Access, AccessCode, Cite, EnumVariant, Field, FieldRef, FieldReset, Ident, Kind, Lanes, MessageId, RegisterId,
    bit_mask,
};
use crate::path::Path;
use crate::syntax::{self, BitRange, EnumDef, EnumValue, ValueKey};

/// Most fields of a register or word: it has no more bits.
const MAX_FIELDS: usize = 64;

/// What holds a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Holder {
    Register(RegisterId),
    Word(MessageId, usize),
}

/// Rules of a field that name other fields.
pub(crate) struct PendingRules {
    pub holder: Holder,
    pub field: String,
    pub at: Path,
    pub when: Option<(String, Path)>,
    pub set_when: Option<(String, Path)>,
    pub loads: Option<(String, Path)>,
}

/// What a field takes from its register or word.
pub(super) struct Outer<'a> {
    pub name: &'a str,
    /// What the names of the fields' own enumerations start with.
    pub enum_prefix: &'a str,
    pub at: &'a Path,
    pub width: u32,
    pub access: Option<AccessCode>,
    pub when: Option<&'a str>,
    pub cites: &'a [Cite],
    /// The register gives the reset of all its fields.
    pub has_reset: bool,
    pub holder: Holder,
}

impl Lowering<'_> {
    pub(super) fn fields(
        &mut self,
        list: &IndexMap<String, syntax::Field>,
        origins: &IndexMap<String, Path>,
        outer: &Outer<'_>,
    ) -> (Vec<Field>, Vec<Path>) {
        let mut fields = Vec::new();
        let mut paths = Vec::new();
        if list.len() > MAX_FIELDS {
            let title = format!("`{}` has {} fields, more than bits", outer.name, list.len());
            self.find(
                Diagnostic::new(Code::OutOfRange, Spot::Key(outer.at.key("fields")), title)
                    .help("a field that repeats in a register is one field with `lanes`"),
            );
        }
        for (name, text) in list.iter().take(MAX_FIELDS) {
            let at = origins.get(name).cloned().unwrap_or_else(|| outer.at.key("fields").key(name));
            match self.field(name, text, &at, outer) {
                Some(field) => {
                    fields.push(field);
                    paths.push(at);
                }
                None => {
                    self.lost_fields.insert((outer.holder, name.clone()));
                }
            }
        }
        (fields, paths)
    }

    fn field(&mut self, name: &str, text: &syntax::Field, at: &Path, outer: &Outer<'_>) -> Option<Field> {
        let BitRange { msb, lsb } = text.bits;
        let bits_at = Spot::Value(at.key("bits"));
        if msb < lsb {
            self.find(
                Diagnostic::new(Code::ReversedBits, bits_at, format!("the bits of `{name}` are written upside down"))
                    .label(format!("write \"{lsb}:{msb}\""))
                    .help("the most significant bit comes first, as on the register's page"),
            );
            return None;
        }
        let width = msb - lsb + 1;
        let lanes = match text.lanes {
            Some(lanes) => {
                let stride = lanes.stride.unwrap_or(width);
                if lanes.count == 0 || lanes.count > 64 {
                    self.find(
                        Diagnostic::new(
                            Code::OutOfRange,
                            Spot::Value(at.key("lanes").key("count")),
                            format!("a field cannot have {} lanes", lanes.count),
                        )
                        .label("has to be 1 to 64"),
                    );
                    return None;
                }
                if stride < width {
                    self.find(
                        Diagnostic::new(
                            Code::StrideTooSmall,
                            Spot::Value(at.key("lanes").key("stride")),
                            format!("the lanes of `{name}` overlap: {width} bits wide, {stride} apart"),
                        )
                        .label(format!("has to be at least {width}")),
                    );
                    return None;
                }
                let first = self.first(lanes.first, &at.key("lanes").key("first"));
                Some(Lanes { count: lanes.count, stride, first })
            }
            None => None,
        };
        let reach = u64::from(msb) + lanes.map_or(0, |l| u64::from(l.count - 1) * u64::from(l.stride));
        if reach >= u64::from(outer.width) {
            self.find(
                Diagnostic::new(
                    Code::FieldOutside,
                    bits_at,
                    format!("`{name}` reaches bit {reach} of `{}`, which has {} bits", outer.name, outer.width),
                )
                .label(format!("the last bit is {}", outer.width - 1)),
            );
            return None;
        }
        self.check_identifier(name, at);
        self.cite(text.cite.as_ref(), at);
        let own_cites = cites(text.cite.as_ref());
        self.check_name(text.name.as_ref(), at);
        if own_cites.is_empty() {
            self.repeat(weight(outer.cites), at);
        }
        let access = self.access(name, text, at, outer)?;
        let kind = self.kind(name, text, at, outer, width);
        let capacity = bit_mask(0, width);
        let limit = |int: Option<syntax::Int>, default: u64| int.map_or(default, |i| i.0);
        let (min, max) = text.range.map_or((0, capacity), |r| (limit(r.min, 0), limit(r.max, capacity)));
        for (value, key) in [(min, "min"), (max, "max")] {
            if value > capacity {
                self.find(
                    Diagnostic::new(
                        Code::LimitTooWide,
                        Spot::Value(at.key("range").key(key)),
                        format!("{value} does not fit the {} of `{name}`", bits(width)),
                    )
                    .label(format!("has to be at most {capacity}")),
                );
            }
        }
        if min > max && min <= capacity {
            self.find(Diagnostic::new(
                Code::BadRange,
                Spot::Value(at.key("range")),
                format!("no value of `{name}` is at least {min} and at most {max}"),
            ));
        }
        if let Some(must) = text.must_write
            && must.0 > capacity
        {
            self.find(
                Diagnostic::new(
                    Code::LimitTooWide,
                    Spot::Value(at.key("must_write")),
                    format!("{} does not fit the {} of `{name}`", must.0, bits(width)),
                )
                .label(format!("has to be at most {capacity}")),
            );
        }
        if text.encoding.as_ref().is_some_and(|encoding| encoding.times == Some(0)) {
            self.find(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Value(at.key("encoding").key("times")),
                    format!("every number in `{name}` would mean 0"),
                )
                .label("has to be at least 1"),
            );
        }
        let reset = self.field_reset(name, text, at, outer, width);
        Some(Field {
            name: name.to_owned(),
            label: text.label.clone().unwrap_or_else(|| name.to_owned()),
            ident: Ident::new(text.name.as_deref().unwrap_or(name)),
            lsb,
            width,
            lanes,
            doc: text.doc.trim().to_owned(),
            cites: if own_cites.is_empty() { outer.cites.to_vec() } else { own_cites },
            access,
            reset,
            kind,
            min,
            max,
            encoding: text.encoding.clone(),
        })
    }

    fn access(&mut self, name: &str, text: &syntax::Field, at: &Path, outer: &Outer<'_>) -> Option<Access> {
        let Some(code) = text.access.or(outer.access) else {
            self.find(
                Diagnostic::new(Code::NoAccess, Spot::Key(at.clone()), format!("`{name}` has no access code"))
                    .label("`access` is missing here and at the register")
                    .help("give `access` to the field, or to the register for all its fields"),
            );
            return None;
        };
        let mismatch =
            |key: &str, title: String| Diagnostic::new(Code::AccessMismatch, Spot::Value(at.key(key)), title);
        if let Some(on_read) = text.on_read {
            if !code.readable() {
                self.find(mismatch("on_read", format!("`{name}` cannot be read, so a read can have no effect on it")));
            }
            if let Some(byte) = on_read.byte
                && u32::from(byte) * 8 >= outer.width
            {
                let last = outer.width / 8 - 1;
                self.find(
                    Diagnostic::new(
                        Code::OutOfRange,
                        Spot::Value(at.key("on_read").key("byte")),
                        format!("`{}` has no byte {byte}", outer.name),
                    )
                    .label(format!("has to be 0 to {last}")),
                );
            }
        }
        if !code.writable() {
            for (key, present) in [
                ("when", text.when.as_deref().is_some_and(|when| when != "always")),
                ("set_when", text.set_when.is_some()),
                ("must_write", text.must_write.is_some()),
                ("safe_to_write_back", text.safe_to_write_back.is_some()),
            ] {
                if present {
                    self.find(
                        mismatch(key, format!("`{name}` is read only, so `{key}` means nothing"))
                            .help("remove it, or give the field another access code"),
                    );
                }
            }
        }
        if text.write_loads.is_some() && code != AccessCode::Wclr {
            self.find(
                mismatch(
                    "write_loads",
                    format!("`{name}` has access `{}`; only `wclr` loads on a write", code.as_str()),
                )
                .help("use `access: wclr` for a field that any write clears or presets"),
            );
        }
        if text.safe_to_write_back.is_some() && code.neutral() != crate::model::Neutral::None && code.writable() {
            self.find(mismatch(
                "safe_to_write_back",
                format!("`{name}` has access `{}`, which has a neutral value anyway", code.as_str()),
            ));
        }
        let rule = |own: &Option<String>, inherited: Option<&str>, key: &str| match own {
            Some(own) => Some((own.clone(), at.key(key))),
            None => inherited.map(|text| (text.to_owned(), outer.at.key(key))),
        };
        let writable = code.writable();
        let when = rule(&text.when, outer.when, "when").filter(|(text, _)| writable && text != "always");
        let set_when = rule(&text.set_when, None, "set_when").filter(|_| writable);
        let loads = rule(&text.write_loads, None, "write_loads");
        if when.is_some() || set_when.is_some() || loads.is_some() {
            self.pending.push(PendingRules {
                holder: outer.holder,
                field: name.to_owned(),
                at: at.clone(),
                when,
                set_when,
                loads,
            });
        }
        Some(Access {
            code,
            on_read: text.on_read,
            when: None,
            set_when: None,
            loads: None,
            safe_to_write_back: text.safe_to_write_back.clone(),
            must_write: text.must_write.map(|v| v.0),
        })
    }

    fn kind(&mut self, name: &str, text: &syntax::Field, at: &Path, outer: &Outer<'_>, width: u32) -> Kind {
        let plain = if width == 1 { Kind::Bool } else { Kind::Int };
        let id = match (&text.enum_ref, &text.values) {
            (Some(_), Some(_)) => {
                self.find(
                    Diagnostic::new(
                        Code::Contradiction,
                        Spot::Key(at.key("enum")),
                        format!("`{name}` has both `enum` and `values`"),
                    )
                    .also(Spot::Key(at.key("values")), "and here")
                    .help("keep `enum` for a shared enumeration, `values` for one of its own"),
                );
                return plain;
            }
            (Some(reference), None) => match self.enum_names.get(reference) {
                Some(id) => *id,
                None => {
                    let hint = self.hint(reference, self.enum_names.keys().map(String::as_str), "unknown enumeration");
                    self.find(
                        Diagnostic::new(
                            Code::UnknownReference,
                            Spot::Value(at.key("enum")),
                            format!("there is no enumeration `{reference}`"),
                        )
                        .label(hint)
                        .help("declare it under `enums`, or list `values` at the field"),
                    );
                    return plain;
                }
            },
            (None, Some(values)) => {
                let enum_name = format!("{}_{}", outer.enum_prefix, text.name.as_deref().unwrap_or(name));
                self.add_enum(&enum_name, false, String::new(), outer.cites.to_vec(), values, &at.key("values"))
            }
            (None, None) => return plain,
        };
        let entry = &mut self.out.model.enums[id.0];
        entry.width = entry.width.max(width);
        let capacity = bit_mask(0, width);
        let of_entry = |v: &EnumVariant| (v.last, v.name.clone());
        let values = entry.variants.iter().map(of_entry);
        let values = values.chain(entry.reserved.iter().map(|r| (r.1, "reserved".to_owned())));
        let too_wide: Vec<_> = values.filter(|(last, _)| *last > capacity).collect();
        for (last, variant) in too_wide {
            let same = |list: &IndexMap<ValueKey, EnumValue>| {
                list.keys().find(|key| key.last == last).map(|key| key.spelling.clone()).unwrap_or_default()
            };
            let title = format!("the value {last} (`{variant}`) does not fit the {} of `{name}`", bits(width));
            let limit = format!("has to be at most {capacity}");
            let wide = |spot| Diagnostic::new(Code::EnumTooWide, spot, title.clone());
            self.find(match (&text.enum_ref, &text.values) {
                (_, Some(values)) => wide(Spot::Key(at.key("values").key(same(values))))
                    .label(limit)
                    .also(Spot::Value(at.key("bits")), "the bits"),
                (Some(shared), None) => {
                    let list = Path::root().key("enums").key(shared);
                    let place = match self.text.enums.get(shared) {
                        Some(EnumDef::Full(full)) => list.key("values").key(same(&full.values)),
                        Some(EnumDef::Short(values)) => list.key(same(values)),
                        None => list,
                    };
                    wide(Spot::Value(at.key("enum"))).label(limit).also(Spot::Key(place), "the value")
                }
                (None, None) => wide(Spot::Key(at.clone())),
            });
        }
        Kind::Enum(id)
    }

    fn field_reset(
        &mut self,
        name: &str,
        text: &syntax::Field,
        at: &Path,
        outer: &Outer<'_>,
        width: u32,
    ) -> FieldReset {
        let capacity = bit_mask(0, width);
        match text.reset {
            Some(syntax::FieldReset::Value(value)) => {
                if value.0 > capacity {
                    self.find(
                        Diagnostic::new(
                            Code::ResetTooWide,
                            Spot::Value(at.key("reset")),
                            format!("the reset {:#x} does not fit the {} of `{name}`", value.0, bits(width)),
                        )
                        .label(format!("the largest value is {capacity:#x}")),
                    );
                }
                FieldReset::Value(value.0 & capacity)
            }
            Some(syntax::FieldReset::Kind(kind)) => FieldReset::None(kind),
            None => {
                if !outer.has_reset {
                    self.find(
                        Diagnostic::new(Code::NoReset, Spot::Key(at.clone()), format!("`{name}` has no reset value"))
                            .label("`reset` is missing here and at the register")
                            .help("give `reset` to the register, or to each of its fields; `unknown` is a value too"),
                    );
                }
                FieldReset::Value(0)
            }
        }
    }

    /// Resolves what fields say about other fields, once all fields exist.
    pub(super) fn rules(&mut self) {
        for rules in std::mem::take(&mut self.pending) {
            let fields = match rules.holder {
                Holder::Register(id) => &self.out.model.registers[id.0].fields,
                Holder::Word(id, word) => &self.out.model.messages[id.0].words[word].fields,
            };
            let Some(index) = fields.iter().position(|f| f.name == rules.field) else { continue };
            let own = match rules.holder {
                Holder::Register(register) => Some(FieldRef { register, field: index }),
                Holder::Word(..) => None,
            };
            let mut condition = |rule: Option<(String, Path)>| {
                let (text, at) = rule?;
                let id = self.condition_ref(&text, &at)?;
                self.check_own_number(id, own, &at);
                Some(id)
            };
            let when = condition(rules.when);
            let set_when = condition(rules.set_when);
            let loads = rules.loads.and_then(|(text, at)| self.field_ref(&text, &at));
            let fields = match rules.holder {
                Holder::Register(id) => &mut self.out.model.registers[id.0].fields,
                Holder::Word(id, word) => &mut self.out.model.messages[id.0].words[word].fields,
            };
            let access = &mut fields[index].access;
            access.when = when;
            access.set_when = set_when;
            access.loads = loads;
            if let (Some(own), Some(target)) = (own, loads)
                && self.out.model.field(own).width != self.out.model.field(target).width
            {
                let bits = |at: FieldRef| (self.out.model.field_path(at), self.out.model.field(at).width);
                let ((own, width), (target, other)) = (bits(own), bits(target));
                self.find(
                    Diagnostic::new(
                        Code::AccessMismatch,
                        Spot::Value(rules.at.key("write_loads")),
                        format!("`{own}` has {width} bits, `{target}` has {other}"),
                    )
                    .help("a write can load only a field that is as wide"),
                );
            }
        }
    }
}

/// "1 bit" or "3 bits".
fn bits(width: u32) -> String {
    if width == 1 { "1 bit".to_owned() } else { format!("{width} bits") }
}
