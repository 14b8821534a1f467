package lightning.editor.window.model;

import java.io.IOException;
import lightning.base.file.FileSentence;
import lightning.base.text.Texts;
import lightning.base.text.Told;
import lightning.render.relight.PictureTooLarge;

/** What went wrong, as a sentence for the artist. */
public final class Sentence {
    private Sentence() {}

    public static String of(Throwable problem) {
        return switch (problem) {
            case Told told -> told.getMessage();
            case IOException e -> FileSentence.of(e);
            case PictureTooLarge e -> Texts.of("This is too large: {0}", e.getMessage());
            case OutOfMemoryError _ -> Texts.of("There is not enough memory for this picture; choose a smaller size");
            default -> Texts.of("An error of the program itself, not of your input: {0}; please report it with the scene", problem);
        };
    }
}
