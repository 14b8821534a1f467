package lightning.app;

/** The texts of the Help menu. */
final class About {
    private static final String KEYS = """
            Lights, in the preview
              left drag: rotate          arrows
              middle drag, Alt + drag: along the view, up is away          Page Up, Page Down
              right drag: in the viewing plane          Ctrl + arrows
              click: select          [ and ]

            Camera of the preview
              Shift + drag, mostly up or down: zoom          Shift + up, down
              Shift + drag, mostly left or right: pan          Shift + left, right
              Shift + drag from near the edge: turn          Shift + Ctrl + arrows
              along x, from above, reset          X, Y, Z
              through the selected light          L
              back until all lights are in view          A

            Traced picture
              wheel: zoom      middle drag: move
              click: select the light that matters most there
              right click on a shape, here or in the preview: edit its material
            """;

    private About() {}

    static void show(Notices notices) {
        notices.text("Lightning", "Relights ray-traced scenes exactly, in a fraction of a full trace.\n\n"
                + "It traces a scene once, keeps what every pixel needs, and after an edit of a light computes only what "
                + "changed. After \u201cLightning\u201d, Brown University CS-98-09, 1998.");
    }

    static void showKeys(Notices notices) {
        notices.text("Mouse and Keyboard", KEYS);
    }
}
