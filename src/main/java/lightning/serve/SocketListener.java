package lightning.serve;

import java.io.IOException;
import java.net.ConnectException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import lightning.base.file.PrivateFolder;
import lightning.base.text.Quote;
import lightning.base.work.DedicatedThread;

/** Unix domain socket that only the user of this process can connect to. The file of the socket is removed at the end. */
public final class SocketListener implements AutoCloseable {
    static final int MAX_CLIENTS = 32;
    /** The systems' own limits are 103 and 107; the socket is created in a folder with a slightly longer path. */
    private static final int MAX_PATH = 80;

    private final ConnectionHandler handler;
    private final Path path;
    private final ServerSocketChannel channel;
    private final Object fileKey;

    private SocketListener(ConnectionHandler handler, Path path, ServerSocketChannel channel) throws IOException {
        this.handler = handler;
        this.path = path;
        this.channel = channel;
        fileKey = fileKey(path);
    }

    /**
     * Starts to accept clients. Replaces the socket of a server that has ended.
     *
     * @throws IOException if the path is in use or cannot be created; the message is a sentence for the user
     */
    public static SocketListener start(ConnectionHandler handler, Path path) throws IOException {
        check(path);
        removeStale(path);
        // Bound in a folder of the user's own, so that it is never open to others, not even before its mode is set.
        Path folder = path.resolveSibling(".lightning-" + ProcessHandle.current().pid());
        Path hidden = folder.resolve("s");
        ServerSocketChannel channel = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
        boolean complete = false;
        try {
            PrivateFolder.restrict(folder);
            channel.bind(UnixDomainSocketAddress.of(hidden));
            var view = Files.getFileAttributeView(hidden, PosixFileAttributeView.class);
            if (view != null) {
                view.setPermissions(PosixFilePermissions.fromString("rw-------"));
            }
            Files.move(hidden, path);
            var listener = new SocketListener(handler, path, channel);
            DedicatedThread.create("lightning-socket", listener::accept).start();
            complete = true;
            return listener;
        } finally {
            if (!complete) {
                channel.close();
            }
            Files.deleteIfExists(hidden);
            Files.deleteIfExists(folder);
        }
    }

    private static void check(Path path) throws IOException {
        Path folder = path.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new IOException(Quote.path(path) + ": folder not found");
        }
        int bytes = path.toString().getBytes(StandardCharsets.UTF_8).length;
        if (bytes > MAX_PATH) {
            throw new IOException(Quote.path(path) + ": the path of a socket may have at most " + MAX_PATH + " bytes, found " + bytes);
        }
    }

    private static void removeStale(Path path) throws IOException {
        if (!Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
            return;
        }
        if (!Files.readAttributes(path, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS).isOther()) {
            throw new IOException(Quote.path(path) + ": exists already and is not a socket");
        }
        try (SocketChannel _ = SocketChannel.open(UnixDomainSocketAddress.of(path))) {
            throw new IOException(Quote.path(path) + ": another server uses this socket");
        } catch (ConnectException e) {
            Files.delete(path);
        }
    }

    private static Object fileKey(Path path) throws IOException {
        return Files.readAttributes(path, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS).fileKey();
    }

    private void accept() {
        while (channel.isOpen()) {
            try {
                SocketChannel client = channel.accept();
                if (handler.clientCount() >= MAX_CLIENTS) {
                    client.close();
                } else {
                    handler.accept(Channels.newInputStream(client), Channels.newOutputStream(client), client);
                }
            } catch (IOException e) {
                // Closed, or the client left before it was accepted.
                pause();
            }
        }
    }

    /** Leaves the processor to others if each try fails, for example because no file handle is free. */
    private void pause() {
        try {
            Thread.sleep(channel.isOpen() ? 50 : 0);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Stops accepting clients and removes the file, unless another server has replaced it. */
    @Override
    public void close() throws IOException {
        channel.close();
        if (Files.exists(path, LinkOption.NOFOLLOW_LINKS) && fileKey(path).equals(fileKey)) {
            Files.delete(path);
        }
    }
}
