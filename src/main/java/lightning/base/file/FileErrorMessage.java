package lightning.base.file;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import lightning.base.text.Messages;
import lightning.base.text.Quote;

/** Messages for Java's file exceptions, whose own messages are mostly only the file's name. */
public final class FileErrorMessage {
    private FileErrorMessage() {}

    /** Returns a sentence without its full stop. */
    public static String of(IOException e) {
        return switch (e) {
            case NoSuchFileException missing -> Messages.tr("{0}: file not found", Quote.path(missing.getFile()));
            case AccessDeniedException denied -> Messages.tr("{0}: permission denied", Quote.path(denied.getFile()));
            case NotDirectoryException no -> Messages.tr("{0}: is not a folder", Quote.path(no.getFile()));
            case FileAlreadyExistsException there -> Messages.tr("{0}: already exists and is not a folder", Quote.path(there.getFile()));
            case FileSystemException other when other.getReason() != null -> Quote.path(other.getFile()) + ": " + other.getReason();
            default -> e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
        };
    }
}
