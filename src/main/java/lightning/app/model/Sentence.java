package lightning.app.model;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import lightning.relight.PictureTooLarge;
import lightning.text.Quote;

/** What went wrong, as a sentence for the artist. */
public final class Sentence {
    private Sentence() {}

    public static String of(Throwable problem) {
        return switch (problem) {
            case NoSuchFileException missing -> Quote.path(missing.getFile()) + ": there is no such file";
            case AccessDeniedException denied -> Quote.path(denied.getFile()) + ": permission denied";
            case FileSystemException other when other.getReason() != null -> Quote.path(other.getFile()) + ": " + other.getReason();
            case IOException e when e.getMessage() != null -> e.getMessage();
            case PictureTooLarge e -> "This is too large: " + e.getMessage();
            case OutOfMemoryError _ -> "There is not enough memory for this picture; choose a smaller size";
            default -> "An error of the program itself, not of your input: " + problem + "; please report it with the scene";
        };
    }
}
