package lightning.serve;

import java.io.Closeable;
import java.io.InputStream;
import java.io.OutputStream;

/** Receiver of the clients of a socket. */
public interface ConnectionHandler {
    /** Returns the number of connected clients, which is limited. */
    int clientCount();

    /**
     * Starts to answer a client and returns at once.
     *
     * @param connection is closed after the last answer
     */
    void accept(InputStream in, OutputStream out, Closeable connection);
}
