//! Enums whose variants have a word each.

/// Declares such an enum. A word stands beside its variant, and nowhere else.
macro_rules! words {
    ($(#[$doc:meta])* $visibility:vis $name:ident { $($(#[$variant_doc:meta])* $variant:ident = $word:literal,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
        $visibility enum $name { $($(#[$variant_doc])* $variant,)* }

        impl $name {
            /// Every value.
            #[allow(dead_code)]
            pub const ALL: [$name; [$($word),*].len()] = [$($name::$variant,)*];

            /// The word.
            pub const fn word(self) -> &'static str {
                match self { $($name::$variant => $word,)* }
            }

            /// The value that a word stands for.
            #[allow(dead_code)]
            pub fn find(word: &str) -> Option<$name> {
                Self::ALL.into_iter().find(|value| value.word() == word)
            }
        }
    };
}

pub(crate) use words;
