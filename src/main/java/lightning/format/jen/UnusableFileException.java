package lightning.format.jen;

import lightning.base.text.Told;

/** Says in a sentence why a file that a scene names cannot be used. */
public final class UnusableFileException extends Exception implements Told {
    private static final long serialVersionUID = 1;

    UnusableFileException(String message) {
        super(message);
    }
}
