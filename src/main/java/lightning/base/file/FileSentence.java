package lightning.base.file;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import lightning.base.text.Quote;
import lightning.base.text.Texts;

/** What Java's file errors mean; their own messages are mostly just the file's name. */
public final class FileSentence {
    private FileSentence() {}

    /** A sentence without its full stop. */
    public static String of(IOException e) {
        return switch (e) {
            case NoSuchFileException missing -> Texts.of("{0}: there is no such file", Quote.path(missing.getFile()));
            case AccessDeniedException denied -> Texts.of("{0}: permission denied", Quote.path(denied.getFile()));
            case NotDirectoryException no -> Texts.of("{0}: is no folder", Quote.path(no.getFile()));
            case FileAlreadyExistsException there -> Texts.of("{0}: is there already and is no folder", Quote.path(there.getFile()));
            case FileSystemException other when other.getReason() != null -> Quote.path(other.getFile()) + ": " + other.getReason();
            default -> e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
        };
    }
}
