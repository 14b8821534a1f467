package lightning.base.file;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.UUID;

/**
 * Names the processes that can look each other up by number: those of one user on one machine, and of containers those of one.
 * Folders are shared between machines, where the same number is another process; and some systems hide the processes of other users.
 */
final class ProcessNamespace {
    /** The realm of this process: 8 hexadecimal digits, always the same for one user, host name and namespace of processes. */
    static final String NAME = hash(host() + "\n" + namespace() + "\n" + System.getProperty("user.name"));

    private ProcessNamespace() {}

    private static String hash(String text) {
        return UUID.nameUUIDFromBytes(text.getBytes(StandardCharsets.UTF_8)).toString().substring(0, 8);
    }

    /** Without a question to a name server, which may take seconds to answer, on Linux and Windows. */
    private static String host() {
        try {
            return Files.readString(Path.of("/proc/sys/kernel/hostname"));
        } catch (IOException e) {
            String windows = System.getenv("COMPUTERNAME");
            return windows == null ? resolvedHost() : windows;
        }
    }

    private static String resolvedHost() {
        try {
            return InetAddress.getLocalHost().getHostName();
        } catch (UnknownHostException e) {
            return "";
        }
    }

    /** Containers with the host's name have process numbers of their own; only Linux has such, and names them by this link. */
    private static String namespace() {
        try {
            return Files.readSymbolicLink(Path.of("/proc/self/ns/pid")).toString();
        } catch (IOException | UnsupportedOperationException e) {
            return "";
        }
    }
}
