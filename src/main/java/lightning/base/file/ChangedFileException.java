package lightning.base.file;

import java.io.IOException;
import java.nio.file.Path;
import lightning.base.text.Quote;

/** Thrown if replacing a file would lose changes that another program made. */
public final class ChangedFileException extends IOException {
    private static final long serialVersionUID = 1;

    ChangedFileException(Path file) {
        super(Quote.path(file) + ": was changed by another program since it was last opened or saved");
    }
}
