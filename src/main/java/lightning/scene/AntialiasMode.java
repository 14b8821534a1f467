package lightning.scene;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import lightning.base.text.RefusalException;

/** Pixels that receive several samples. */
public enum AntialiasMode {
    /** None: each pixel has one sample, at its center. */
    OFF,
    /** Pixels at an edge of a shape, shadow, texture, highlight or mirror image. */
    EDGES,
    /** All pixels. */
    EVERY;

    /** Keywords in files, in order. */
    public static final List<String> WORDS = Stream.of(values()).map(AntialiasMode::word).toList();

    /** Returns the keyword in files. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Returns the mode with a keyword; throws an {@link IllegalArgumentException} if there is none. */
    public static AntialiasMode of(String word) {
        return Stream.of(values()).filter(mode -> mode.word().equals(word)).findFirst()
                .orElseThrow(() -> new RefusalException(word));
    }
}
