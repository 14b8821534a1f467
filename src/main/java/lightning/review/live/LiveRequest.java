package lightning.review.live;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Head of a request of HTTP/1.1 (RFC 9112) as browsers and scripts send it: its length comes first, and nothing follows it on the connection.
 *
 * @param path   path without a query
 * @param length bytes of the content
 * @param begun  bytes of the content that were read with the head
 */
record LiveRequest(String method, String path, long length, byte[] begun) {
    // An array in a record: written once by its creator, never after.
    private static final int MAX_HEAD = 16 << 10;
    private static final Pattern START = Pattern.compile("(?<method>[A-Z]{1,20}) (?<path>/[!-~]*) HTTP/1\\.[01]");
    private static final Pattern LENGTH = Pattern.compile("\\d{1,15}");

    /** A request that is not understood. */
    static final class BadRequestException extends IOException {
        private static final long serialVersionUID = 1;

        BadRequestException(String message) {
            super(message);
        }
    }

    /**
     * Reads a head.
     *
     * @param milliseconds time for all of it
     * @throws BadRequestException if it is none; the message is one sentence
     * @throws IOException         if it does not arrive in time
     */
    static LiveRequest read(Socket socket, long milliseconds) throws IOException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(milliseconds);
        var head = new ByteArrayOutputStream();
        byte[] buffer = new byte[2048];
        while (true) {
            int count = read(socket, buffer, end);
            if (count < 0) {
                throw new IOException("the connection ended");
            }
            head.write(buffer, 0, count);
            byte[] bytes = head.toByteArray();
            // Every byte is one character.
            String text = new String(bytes, StandardCharsets.ISO_8859_1);
            int length = text.indexOf("\r\n\r\n");
            if (length >= 0) {
                byte[] begun = new byte[bytes.length - length - 4];
                System.arraycopy(bytes, length + 4, begun, 0, begun.length);
                return parse(text.substring(0, length).split("\r\n"), begun);
            }
            if (bytes.length > MAX_HEAD) {
                throw new BadRequestException("The head of a request has at most " + MAX_HEAD + " bytes.");
            }
        }
    }

    private static int read(Socket socket, byte[] to, long end) throws IOException {
        long rest = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
        if (rest <= 0) {
            throw new SocketTimeoutException();
        }
        socket.setSoTimeout((int) rest);
        return socket.getInputStream().read(to);
    }

    private static LiveRequest parse(String[] lines, byte[] begun) throws BadRequestException {
        Matcher start = START.matcher(lines[0]);
        if (!start.matches()) {
            throw new BadRequestException("Expected a request of HTTP/1.1.");
        }
        long length = 0;
        for (int i = 1; i < lines.length; i++) {
            int colon = lines[i].indexOf(':');
            String name = lines[i].substring(0, Math.max(0, colon)).toLowerCase(Locale.ROOT);
            String value = lines[i].substring(colon + 1).strip();
            if (name.equals("transfer-encoding") || name.equals("content-length") && !LENGTH.matcher(value).matches()) {
                throw new BadRequestException("Expected the length of the content in bytes.");
            }
            length = name.equals("content-length") ? Long.parseLong(value) : length;
        }
        String path = start.group("path");
        return new LiveRequest(start.group("method"), path.substring(0, (path + "?").indexOf('?')), length, begun);
    }

    /**
     * Reads the content.
     *
     * @throws IOException if it does not arrive in time
     */
    byte[] content(Socket socket, long milliseconds) throws IOException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(milliseconds);
        var content = new ByteArrayOutputStream();
        content.write(begun);
        byte[] buffer = new byte[1 << 14];
        while (content.size() < length) {
            int count = read(socket, buffer, end);
            if (count < 0) {
                throw new IOException("the connection ended");
            }
            content.write(buffer, 0, count);
        }
        return content.toByteArray();
    }

    /** Reads what is still sent, and drops it: the client of a connection that ends before may not see its answer. */
    void skipContent(Socket socket, long milliseconds) throws IOException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(milliseconds);
        byte[] buffer = new byte[1 << 14];
        long rest = length - begun.length;
        while (rest > 0) {
            int count = read(socket, buffer, end);
            rest = count < 0 ? 0 : rest - count;
        }
    }
}
