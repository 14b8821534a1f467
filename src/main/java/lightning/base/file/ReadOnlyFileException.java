package lightning.base.file;

import java.io.IOException;
import java.nio.file.Path;
import lightning.base.text.Quote;

/** Thrown if an existing file is read-only; replacing it would bypass the protection. */
public final class ReadOnlyFileException extends IOException {
    private static final long serialVersionUID = 1;

    ReadOnlyFileException(Path file) {
        super(Quote.path(file) + ": is read-only; allow writing it, or choose another name");
    }
}
