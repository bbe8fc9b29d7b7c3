//! The struct, its description and its visit.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Error, Expr, Field, Fields, Ident, ItemStruct, Result, Type, TypeArray};

use crate::annotation::{Annotations, RecordArguments};

/// Rust integers that a field may be.
const WORDS: [&str; 5] = ["bool", "u8", "u16", "u32", "u64"];

/// How a field's type is made of words and records.
enum Shape<'a> {
    Word(&'a Ident),
    Array(Box<Shape<'a>>, &'a Expr),
    Record(&'a Type),
}

impl<'a> Shape<'a> {
    fn of(ty: &'a Type) -> Self {
        match ty {
            Type::Array(TypeArray { elem, len, .. }) => Self::Array(Box::new(Self::of(elem)), len),
            _ => word(ty).map_or(Self::Record(ty), Self::Word),
        }
    }

    /// The integer that an array is made of.
    fn word(&self) -> Option<&Ident> {
        match self {
            Self::Word(word) => Some(word),
            Self::Array(element, _) => element.word(),
            Self::Record(_) => None,
        }
    }

    /// The type in a domain.
    fn typed(&self) -> TokenStream {
        match self {
            Self::Word(word) => quote!(D::Bits<#word>),
            Self::Array(element, length) => {
                let element = element.typed();
                quote!([#element; #length])
            }
            Self::Record(record) => quote!(#record<D>),
        }
    }
}

/// The integer that a type is.
pub fn word(ty: &Type) -> Option<&Ident> {
    let Type::Path(path) = ty else { return None };
    path.path.get_ident().filter(|name| WORDS.iter().any(|word| *name == word))
}

struct Member<'a> {
    name: &'a Ident,
    shape: Shape<'a>,
    annotations: Annotations,
}

impl<'a> Member<'a> {
    fn of(field: &'a Field) -> Result<Self> {
        let name = field.ident.as_ref().ok_or_else(|| Error::new_spanned(field, "a record's fields have names"))?;
        let annotations = Annotations::of(field)?;
        if annotations.documentation.is_empty() {
            return Err(Error::new_spanned(name, "say what the field holds: documents are made of it"));
        }
        Ok(Self { name, shape: Shape::of(&field.ty), annotations })
    }

    fn declaration(&self) -> TokenStream {
        let (name, ty, docs) = (self.name, self.shape.typed(), &self.annotations.documentation);
        quote!(#(#docs)* pub #name: #ty)
    }

    /// The name and width of a word; `i` and `j` are in scope where it is one of an array.
    fn push(&self, word: &Ident, suffix: &TokenStream) -> Result<TokenStream> {
        let bits = match &self.annotations.bits {
            Some(bits) => quote!(#bits),
            None if word == "bool" => quote!(1),
            None => return Err(Error::new_spanned(word, "say how many bits it has: #[bits(…)]")),
        };
        let name = match &self.annotations.name {
            Some(name) => quote!(::std::string::ToString::to_string(&#name)),
            None => {
                let own = self.name.to_string();
                quote!(::std::format!("{}{}", #own, #suffix))
            }
        };
        let below = match &self.annotations.below {
            Some(below) => quote!(::std::option::Option::Some(::std::convert::Into::into(#below))),
            None => quote!(::std::option::Option::None),
        };
        let doc = self.annotations.text();
        Ok(quote!(fields.push(::pointcore_contract::Field { name: #name, width: #bits, below: #below, doc: #doc });))
    }

    fn describe(&self) -> Result<TokenStream> {
        let described = match &self.shape {
            Shape::Word(word) => self.push(word, &quote!(""))?,
            Shape::Record(record) => {
                let config = self.annotations.config();
                quote!(<#record<D> as ::pointcore_contract::Record>::describe(#config, fields);)
            }
            Shape::Array(element, length) => {
                let count = self.count(length);
                let inner = match &**element {
                    Shape::Word(word) => self.push(word, &quote!(i))?,
                    Shape::Array(inner, length) => match &**inner {
                        Shape::Word(word) => {
                            let push = self.push(word, &quote!(::std::format_args!("{i}_{j}")))?;
                            quote!(for j in 0..#length { #push })
                        }
                        _ => return Err(Error::new_spanned(self.name, "arrays of arrays hold integers")),
                    },
                    Shape::Record(_) => return Err(Error::new_spanned(self.name, "arrays hold integers")),
                };
                quote!(for i in 0..#count { #inner })
            }
        };
        Ok(self.only_when(&described))
    }

    fn count(&self, length: &Expr) -> TokenStream {
        match &self.annotations.count {
            Some(count) => quote!((#count) as usize),
            None => quote!(#length),
        }
    }

    fn visit(&self) -> TokenStream {
        let name = self.name;
        let visited = match &self.shape {
            Shape::Word(word) => quote!(visitor.bits::<#word>(&mut self.#name);),
            Shape::Record(_) => {
                let config = self.annotations.config();
                quote!(::pointcore_contract::Visit::visit(&mut self.#name, #config, visitor);)
            }
            Shape::Array(element, length) => {
                let count = self.count(length);
                let word = element.word();
                let each = match &**element {
                    Shape::Array(..) => quote!(value.iter_mut().for_each(|value| visitor.bits::<#word>(value));),
                    _ => quote!(visitor.bits::<#word>(value);),
                };
                quote!(for value in &mut self.#name[..#count] { #each })
            }
        };
        self.only_when(&visited)
    }

    fn only_when(&self, then: &TokenStream) -> TokenStream {
        match &self.annotations.when {
            Some(condition) => quote!(if #condition { #then }),
            None => quote!(#then),
        }
    }
}

pub fn expand(arguments: &RecordArguments, item: &ItemStruct) -> Result<TokenStream> {
    let RecordArguments { binding, config } = arguments;
    let (name, visibility) = (&item.ident, &item.vis);
    let about = Annotations::parse(&item.attrs)?;
    let docs = &about.documentation;
    let Fields::Named(fields) = &item.fields else {
        return Err(Error::new_spanned(item, "a record's fields have names"));
    };
    let members = fields.named.iter().map(Member::of).collect::<Result<Vec<_>>>()?;
    let declarations = members.iter().map(Member::declaration);
    let descriptions = members.iter().map(Member::describe).collect::<Result<Vec<_>>>()?;
    let visits = members.iter().map(Member::visit);
    let names: Vec<_> = members.iter().map(|member| member.name).collect();
    let text = about.text();
    Ok(quote! {
        #(#docs)*
        #[derive(Clone, Copy, Debug, Default)]
        #visibility struct #name<D: ::pointcore_contract::Domain = ::pointcore_contract::Words> {
            #(#declarations),*
        }

        impl<D: ::pointcore_contract::Domain> ::pointcore_contract::Visit<D> for #name<D> {
            type Config = #config;

            fn visit(&mut self, config: &#config, visitor: &mut impl ::pointcore_contract::Visitor<D>) {
                let #binding = config;
                let _ = #binding;
                #(#visits)*
            }
        }

        impl<D: ::pointcore_contract::Domain> ::pointcore_contract::Record for #name<D> {
            type Domain = D;
            type In<E: ::pointcore_contract::Domain> = #name<E>;
            const DOC: &'static str = #text;

            fn describe(config: &#config, fields: &mut ::std::vec::Vec<::pointcore_contract::Field>) {
                let #binding = config;
                let _ = #binding;
                #(#descriptions)*
            }
        }

        impl ::std::cmp::PartialEq for #name {
            fn eq(&self, other: &Self) -> bool {
                true #(&& self.#names == other.#names)*
            }
        }

        impl ::std::cmp::Eq for #name {}
    })
}
