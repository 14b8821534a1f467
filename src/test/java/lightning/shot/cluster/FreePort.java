package lightning.shot.cluster;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;

/**
 * Free ports that no other process takes before the caller does. They are below the ephemeral ports (RFC 6056: from 49152; Linux: from
 * 32768), each is returned once, and parallel processes start at different ones.
 */
public final class FreePort {
    private static final int FIRST = 20_000;
    private static final int BLOCKS = 180;
    /** More than the tests of one process need. */
    private static final int BLOCK = 64;

    private static int nextCandidate = FIRST + (int) (ProcessHandle.current().pid() % BLOCKS) * BLOCK;

    private FreePort() {}

    /** Returns the next port that is free at this machine's own address. */
    public static synchronized int next() {
        while (!isFree(++nextCandidate)) {
            // Another program uses it.
        }
        return nextCandidate;
    }

    private static boolean isFree(int port) {
        try (var socket = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
            return socket.isBound();
        } catch (IOException e) {
            return false;
        }
    }
}
