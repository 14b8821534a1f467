package lightning.shot.cluster;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;

/**
 * Ports that nobody takes before who asked for them does: below those that systems give to connections (RFC 6056: from 49152; Linux:
 * from 32768), each is told once, and processes beside each other begin at different ones.
 */
public final class FreePort {
    private static final int FIRST = 20_000;
    private static final int BLOCKS = 180;
    /** More than the tests of a process ask for. */
    private static final int BLOCK = 64;

    private static int nextCandidate = FIRST + (int) (ProcessHandle.current().pid() % BLOCKS) * BLOCK;

    private FreePort() {}

    /** The next of this machine's own address that is free now. */
    public static synchronized int next() {
        while (!isFree(++nextCandidate)) {
            // Another program's.
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
