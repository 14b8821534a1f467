package lightning.base.file;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.UUID;

/**
 * Identifier of the processes that can look each other up by process id: those of one user, machine and container. Shared folders may hold
 * ids of other machines, and some systems hide the processes of other users.
 */
final class ProcessNamespace {
    /** Identifier of this process's namespace: 8 hexadecimal digits, constant for a user, host name and process namespace. */
    static final String NAME = hash(host() + "\n" + namespace() + "\n" + System.getProperty("user.name"));

    private ProcessNamespace() {}

    private static String hash(String text) {
        return UUID.nameUUIDFromBytes(text.getBytes(StandardCharsets.UTF_8)).toString().substring(0, 8);
    }

    /** Avoids a name server query, which may take seconds, on Linux and Windows. */
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

    /** Containers with the host's name have their own process ids; only Linux has such namespaces and names them by this link. */
    private static String namespace() {
        try {
            return Files.readSymbolicLink(Path.of("/proc/self/ns/pid")).toString();
        } catch (IOException | UnsupportedOperationException e) {
            return "";
        }
    }
}
