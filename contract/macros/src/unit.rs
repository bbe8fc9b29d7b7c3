//! What a model sees and shows, and the description of the ports.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{
    Error, Expr, ExprLit, Field, Fields, GenericArgument, Ident, ItemStruct, Lit, LitStr, PathArguments, Result, Type,
    TypeArray,
};

use crate::annotation::{Annotations, RecordArguments, UnitArguments};
use crate::record::word;

/// What a unit's field says of its ports.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    In,
    Out,
    PulseIn,
    PulseOut,
    Input,
    Output,
}

impl Kind {
    pub fn of(name: &Ident) -> Result<Self> {
        Ok(match name.to_string().as_str() {
            "In" => Self::In,
            "Out" => Self::Out,
            "PulseIn" => Self::PulseIn,
            "PulseOut" => Self::PulseOut,
            "Input" => Self::Input,
            "Output" => Self::Output,
            _ => return Err(Error::new(name.span(), "expected In, Out, PulseIn, PulseOut, Input or Output")),
        })
    }

    /// Its fields come into the unit.
    const fn comes_in(self) -> bool {
        matches!(self, Self::In | Self::PulseIn | Self::Input)
    }

    /// It is there while `valid` is high only.
    const fn has_valid(self) -> bool {
        !matches!(self, Self::Input | Self::Output)
    }

    const fn has_ready(self) -> bool {
        matches!(self, Self::In | Self::Out)
    }
}

pub(crate) struct Port<'a> {
    field: &'a Ident,
    name: LitStr,
    kind: Kind,
    kind_name: &'a Ident,
    record: &'a Type,
    /// Groups of such ports at most, where there may be several: `[In<R>; 4]`.
    most: Option<usize>,
    annotations: Annotations,
}

/// How many an array type says.
fn length(array: &TypeArray) -> Result<usize> {
    match &array.len {
        Expr::Lit(ExprLit { lit: Lit::Int(length), .. }) => length.base10_parse(),
        other => Err(Error::new_spanned(other, "expected a number: names are made of it")),
    }
}

/// The type of one of a field's, and how many there are at most where there may be several.
pub(crate) fn one_of(ty: &Type) -> Result<(&Type, Option<usize>)> {
    Ok(match ty {
        Type::Array(array) => (&*array.elem, Some(length(array)?)),
        ty => (ty, None),
    })
}

/// What several are called: the first without a number, so that it is the same where there is but one.
pub(crate) fn numbered(name: &LitStr, most: usize) -> Vec<LitStr> {
    let numbered = |number: usize| LitStr::new(&format!("{}_{number}", name.value()), name.span());
    std::iter::once(name.clone()).chain((1..most).map(numbered)).collect()
}

impl<'a> Port<'a> {
    /// What a field of a unit says.
    pub fn of(field: &'a Field) -> Result<Self> {
        let Some(ident) = &field.ident else { return Err(Error::new_spanned(field, "a unit's ports have names")) };
        let expected = || Error::new_spanned(&field.ty, "expected a kind of port with its record: In<R>");
        let (ty, most) = one_of(&field.ty)?;
        let Type::Path(path) = ty else { return Err(expected()) };
        let segment = path.path.segments.last().ok_or_else(expected)?;
        let PathArguments::AngleBracketed(arguments) = &segment.arguments else { return Err(expected()) };
        let Some(GenericArgument::Type(record)) = arguments.args.first() else { return Err(expected()) };
        let annotations = Annotations::of(field)?;
        if annotations.documentation.is_empty() {
            return Err(Error::new_spanned(ident, "say what the port is for: documents are made of it"));
        }
        let name = annotations.port.clone().unwrap_or_else(|| LitStr::new(&ident.to_string(), ident.span()));
        let kind = Kind::of(&segment.ident)?;
        if most.is_some() != annotations.count.is_some() {
            return Err(Error::new_spanned(ident, "several groups need both: [In<R>; 4] and #[count(…)]"));
        }
        if most.is_some() && !kind.has_ready() {
            return Err(Error::new_spanned(&field.ty, "only streams come in several groups"));
        }
        Ok(Self { field: ident, name, kind, kind_name: &segment.ident, record, most, annotations })
    }

    /// What the groups are called.
    fn names(&self) -> Vec<LitStr> {
        numbered(&self.name, self.most.unwrap_or(1))
    }

    /// A type or a value for each group, or for the only one.
    fn each(&self, ty: &TokenStream) -> TokenStream {
        self.most.map_or(quote!(#ty), |most| quote!([#ty; #most]))
    }

    fn ready(&self) -> Ident {
        format_ident!("{}_ready", self.name.value())
    }

    /// What a model has of it on one side.
    fn declaration(&self, inputs: bool) -> Option<TokenStream> {
        let (field, record, docs) = (self.field, self.record, &self.annotations.documentation);
        if self.kind.comes_in() == inputs {
            let ty = if self.kind.has_valid() { quote!(::std::option::Option<#record>) } else { quote!(#record) };
            let ty = self.each(&ty);
            return Some(quote!(#(#docs)* pub #field: #ty));
        }
        let ready = self.ready();
        let doc = format!("Whether `{}` moves in this cycle.", self.name.value());
        let ty = self.each(&quote!(bool));
        self.kind.has_ready().then(|| quote!(#[doc = #doc] pub #ready: #ty))
    }

    fn visit(&self, inputs: bool) -> Option<TokenStream> {
        let (field, config) = (self.field, self.annotations.config());
        let visited = if self.most.is_some() {
            self.visit_each(inputs)
        } else if self.kind.comes_in() == inputs {
            match (self.kind.has_valid(), word(self.record)) {
                (true, _) => quote!(::pointcore_contract::visit_optional(&mut self.#field, #config, visitor);),
                (false, Some(word)) => quote!(visitor.bits::<#word>(&mut self.#field);),
                (false, None) => quote!(::pointcore_contract::Visit::visit(&mut self.#field, #config, visitor);),
            }
        } else if self.kind.has_ready() {
            let ready = self.ready();
            quote!(visitor.bits::<bool>(&mut self.#ready);)
        } else {
            return None;
        };
        Some(self.only_when(&visited))
    }

    /// The groups that a configuration has.
    fn visit_each(&self, inputs: bool) -> TokenStream {
        let (field, config, count) = (self.field, self.annotations.config(), &self.annotations.count);
        if self.kind.comes_in() == inputs {
            return quote! {
                for group in &mut self.#field[..(#count) as usize] {
                    ::pointcore_contract::visit_optional(group, #config, visitor);
                }
            };
        }
        let ready = self.ready();
        quote!(self.#ready[..(#count) as usize].iter_mut().for_each(|ready| visitor.bits::<bool>(ready));)
    }

    fn only_when(&self, then: &TokenStream) -> TokenStream {
        match &self.annotations.when {
            Some(condition) => quote!(if #condition { #then }),
            None => quote!(#then),
        }
    }

    /// What stands in its place in the description for hardware.
    pub fn descriptor(&self) -> (TokenStream, TokenStream) {
        let (field, kind, record, names) = (self.field, self.kind_name, self.record, self.names());
        let docs = &self.annotations.documentation;
        let (doc, flag) = (self.annotations.text(), self.flag());
        let ty = self.each(&quote!(::pointcore_contract::unit::#kind<#record>));
        let values = quote!(#(::pointcore_contract::unit::#kind::new(#names, #flag, #doc)),*);
        let value = if self.most.is_some() { quote!([#values]) } else { values };
        (quote!(#(#docs)* pub #field: #ty), quote!(#field: #value))
    }

    fn flag(&self) -> LitStr {
        self.annotations.flag.clone().unwrap_or_else(|| LitStr::new("valid", self.field.span()))
    }

    /// Its group in lists.
    pub fn describe(&self) -> Result<TokenStream> {
        let config = self.annotations.config();
        let (names, doc, flag, kind, record) =
            (self.names(), self.annotations.text(), self.flag(), self.kind_name, self.record);
        let count = self.annotations.count.as_ref().map_or(quote!(1), |count| quote!((#count) as usize));
        let fields = match (word(record), &self.annotations.bits) {
            (Some(word), None) if word != "bool" => {
                return Err(Error::new_spanned(word, "say how many bits it has: #[bits(…)]"));
            }
            (Some(_), bits) => {
                let bits = bits.as_ref().map_or(quote!(1), |bits| quote!(#bits));
                quote!(::std::vec![::pointcore_contract::Field {
                    doc: #doc,
                    ..::pointcore_contract::Field::new("", #bits)
                }])
            }
            (None, _) => quote!(::pointcore_contract::fields::<#record>(#config)),
        };
        Ok(self.only_when(&quote! {
            groups.extend([#(#names),*].into_iter().take(#count).map(|name| ::pointcore_contract::unit::Group {
                name,
                channel: ::std::option::Option::None,
                doc: #doc,
                flag: #flag,
                record: ::std::stringify!(#record),
                kind: ::pointcore_contract::unit::Kind::#kind,
                fields: #fields,
            }));
        }))
    }
}

fn side(ports: &[Port], arguments: &RecordArguments, inputs: bool) -> TokenStream {
    let RecordArguments { binding, config } = arguments;
    let (name, doc) = if inputs {
        (format_ident!("In"), "What the unit sees in a cycle.")
    } else {
        (format_ident!("Out"), "What the unit shows in a cycle.")
    };
    let declarations = ports.iter().filter_map(|port| port.declaration(inputs));
    let visits = ports.iter().filter_map(|port| port.visit(inputs));
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct #name {
            #(#declarations),*
        }

        impl ::pointcore_contract::Visit<::pointcore_contract::Words> for #name {
            type Config = #config;

            fn visit(
                &mut self,
                config: &#config,
                visitor: &mut impl ::pointcore_contract::Visitor<::pointcore_contract::Words>,
            ) {
                let #binding = config;
                let _ = #binding;
                #(#visits)*
            }
        }
    }
}

pub fn expand(arguments: &UnitArguments, item: &ItemStruct) -> Result<TokenStream> {
    let UnitArguments { module, record } = arguments;
    let RecordArguments { binding, config } = record;
    let about = Annotations::parse(&item.attrs)?;
    let (docs, text) = (&about.documentation, about.text());
    let Fields::Named(fields) = &item.fields else {
        return Err(Error::new_spanned(item, "a unit's ports have names"));
    };
    let ports = fields.named.iter().map(Port::of).collect::<Result<Vec<_>>>()?;
    let place = format_ident!("{}", snake(&item.ident.to_string()), span = item.ident.span());
    let (inputs, outputs) = (side(&ports, record, true), side(&ports, record, false));
    let (declarations, values): (Vec<_>, Vec<_>) = ports.iter().map(Port::descriptor).unzip();
    let descriptions = ports.iter().map(Port::describe).collect::<Result<Vec<_>>>()?;
    let present = about.when.as_ref().map_or(quote!(true), |condition| quote!(#condition));
    let module = module.to_string();
    Ok(quote! {
        #(#docs)*
        pub mod #place {
            use super::*;

            #inputs
            #outputs

            /// The unit's ports, each with its record, for hardware to declare.
            #[derive(Clone, Copy, Debug)]
            pub struct Ports {
                #(#declarations),*
            }

            /// The unit's ports.
            pub const PORTS: Ports = Ports { #(#values),* };

            fn interface(config: &#config) -> ::pointcore_contract::unit::Interface {
                let #binding = config;
                let _ = #binding;
                let mut groups = ::std::vec::Vec::new();
                #(#descriptions)*
                ::pointcore_contract::unit::Interface { groups }
            }

            fn is_present(config: &#config) -> bool {
                let #binding = config;
                let _ = #binding;
                #present
            }

            /// The unit in lists.
            pub const UNIT: ::pointcore_contract::unit::Unit<#config> = ::pointcore_contract::unit::Unit {
                module: #module,
                doc: #text,
                interface,
                is_present,
            };
        }
    })
}

/// `PointCache` as a module is called.
pub(crate) fn snake(name: &str) -> String {
    let mut snake = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !snake.is_empty() {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}
