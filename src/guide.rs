#![doc = include_str!("guide/links.md")]
#![doc = include_str!("../docs/guide/README.md")]

// Each page ends with its link definitions for the repository. The definitions for this documentation stand before the page, because the first definition of a label counts.
// Files that are only in the repository link to their list in the index. The test `guide` compares both sets of definitions.
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
    // the picture has no address in the documentation, so the page contains its SVG
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
