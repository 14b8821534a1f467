package lightning.base.file;

import java.io.IOException;
import java.nio.file.Path;
import lightning.base.text.Quote;

/** A file that is there may not be written; to replace it would be to write it all the same. */
public final class ReadOnlyFileException extends IOException {
    private static final long serialVersionUID = 1;

    ReadOnlyFileException(Path file) {
        super(Quote.path(file) + ": is read-only; allow writing it, or choose another name");
    }
}
