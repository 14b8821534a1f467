package lightning.scene;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** Tone curve by which a scene's image is shown and saved as PNG. */
public enum ViewCurve {
    SRGB,
    /** No curve. */
    LINEAR,
    /** Blender's Filmic. */
    FILMIC,
    /** Narkowicz's fit of ACES. */
    ACES,
    /** Output transform of ACES 2. */
    ACES2,
    /** AgX in Blender's form. */
    AGX;

    /** Keywords in files, in order. */
    public static final List<String> WORDS = Stream.of(values()).map(ViewCurve::word).toList();

    /** Returns the keyword in files. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Returns the curve with a keyword of {@link #WORDS}. */
    public static ViewCurve of(String word) {
        return valueOf(word.toUpperCase(Locale.ROOT));
    }
}
