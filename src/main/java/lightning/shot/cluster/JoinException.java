package lightning.shot.cluster;

import lightning.base.text.UserFacingException;
import org.jspecify.annotations.Nullable;

/** Thrown if a process cannot join a cluster; the message is a sentence. */
public final class JoinException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    JoinException(String message, @Nullable Throwable cause) {
        super(message, cause);
    }
}
