package lightning.shot.cluster;

import lightning.base.text.Told;

/** A process cannot take part in a cluster; the message is a sentence. */
public final class JoinException extends Exception implements Told {
    private static final long serialVersionUID = 1;

    JoinException(String message, Throwable cause) {
        super(message, cause);
    }
}
