package lightning.editor.window.command;

import lightning.base.text.Texts;

/** What a picture can be exported as. */
enum ExportKind {
    LAYERS_HALF(Texts.key("Layers as OpenEXR, Half…"), ".exr", 16, true),
    LAYERS_FLOAT(Texts.key("Layers as OpenEXR, 32 Bits…"), ".exr", 32, true),
    EXR(Texts.key("Picture as OpenEXR, 32 Bits…"), ".exr", 32, false),
    HDR(Texts.key("Picture as Radiance HDR…"), ".hdr", 8, false),
    PNG(Texts.key("Picture as PNG, 16 Bits…"), ".png", 16, false);

    private final String title;
    private final String ending;
    private final int bits;
    private final boolean layers;

    ExportKind(String title, String ending, int bits, boolean layers) {
        this.title = title;
        this.ending = ending;
        this.bits = bits;
        this.layers = layers;
    }

    /** As a menu has it. */
    String title() {
        return Texts.of(title);
    }

    String ending() {
        return ending;
    }

    /** Of a number. */
    int bits() {
        return bits;
    }

    boolean hasLayers() {
        return layers;
    }
}
