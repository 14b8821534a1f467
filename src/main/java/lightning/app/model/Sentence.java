package lightning.app.model;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import lightning.relight.PictureTooLarge;
import lightning.text.Quote;
import lightning.text.Texts;

/** What went wrong, as a sentence for the artist. */
public final class Sentence {
    private Sentence() {}

    public static String of(Throwable problem) {
        return switch (problem) {
            case NoSuchFileException missing -> Texts.of("{0}: there is no such file", Quote.path(missing.getFile()));
            case AccessDeniedException denied -> Texts.of("{0}: permission denied", Quote.path(denied.getFile()));
            case FileSystemException other when other.getReason() != null -> Quote.path(other.getFile()) + ": " + other.getReason();
            case IOException e when e.getMessage() != null -> e.getMessage();
            case PictureTooLarge e -> Texts.of("This is too large: {0}", e.getMessage());
            case OutOfMemoryError _ -> Texts.of("There is not enough memory for this picture; choose a smaller size");
            default -> Texts.of("An error of the program itself, not of your input: {0}; please report it with the scene", problem);
        };
    }
}
