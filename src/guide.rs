#![doc = include_str!("guide/links.md")]
#![doc = include_str!("../docs/guide/README.md")]

// A page defines its links for the repository, at its end. Before it stand those for here, and the first definition counts: pages link to each other, and what is in the
// repository alone to the index' list of it. The test `guide` compares both.
macro_rules! pages {
    ($($page:ident $file:literal $($after:expr)?;)*) => {$(
        #[doc = include_str!("guide/links.md")]
        #[doc = include_str!(concat!("../docs/guide/", $file, ".md"))]
        $(#[doc = $after])?
        pub mod $page {}
    )*};
}

pages! {
    first_sheet "first-sheet";
    units "units";
    // the picture, which has no address here, is drawn in the page itself
    solver "solver" concat!(
        "\n<style>img[src^='data:image/svg'] { display: none } svg[viewBox='0 0 900 560'] { width: 100%; height: auto }</style>\n\n",
        include_str!("../docs/laboratory/two-corners-16-strain.svg")
    );
    wind "wind";
    colliders "colliders";
    drawing "drawing";
    rest "rest";
    your_board "your-board";
    saving "saving";
    scene_file "scene-file";
    symptoms "symptoms";
}
