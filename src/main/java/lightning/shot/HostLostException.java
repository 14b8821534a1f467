package lightning.shot;

import lightning.base.text.UserFacingException;
import org.jspecify.annotations.Nullable;

/**
 * Thrown if a host of frames is gone, for example because its process ended; other hosts trace its frames again. The message is a sentence.
 */
public final class HostLostException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    public HostLostException(String message, @Nullable Throwable cause) {
        super(message, cause);
    }
}
