package lightning.review.live;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.net.ssl.SSLContext;
import lightning.base.text.Quote;

/**
 * Network address of a live review.
 *
 * @param host address of a network interface; a loopback address for this computer only
 * @param port 1 to 65535, 0 for any free one
 * @param tls  key and certificate; empty for no encryption, which only this computer may use
 */
public record LiveAddress(String host, int port, Optional<SSLContext> tls) {
    private static final Pattern ADDRESS = Pattern.compile("(?<host>[^:\\s\\[\\]]+|\\[[0-9a-fA-F:.]+])(:(?<port>\\d{1,5}))?");
    private static final int MAX_PORT = 65535;

    /** This computer only, any free port. */
    public static final LiveAddress LOCAL = new LiveAddress("127.0.0.1", 0, Optional.empty());

    /**
     * Reads an address such as {@code 192.168.1.5} or {@code studio-7:8443}; in brackets if it contains colons.
     *
     * @throws UnknownHostException if it is no address; the message is a sentence for the user
     */
    public static LiveAddress parse(String text, Optional<SSLContext> tls) throws UnknownHostException {
        Matcher parts = ADDRESS.matcher(text);
        int port = parts.matches() && parts.group("port") != null ? Integer.parseInt(parts.group("port")) : 0;
        if (!parts.matches() || port > MAX_PORT) {
            throw new UnknownHostException("expected an address such as 192.168.1.5 or 192.168.1.5:8443, found " + Quote.of(text));
        }
        return new LiveAddress(parts.group("host"), port, tls);
    }

    /**
     * Returns the address to listen at.
     *
     * @throws UnknownHostException if there is no such address, or other computers could read what is sent; the message is a sentence for
     *                              the user
     */
    InetSocketAddress resolve() throws UnknownHostException {
        InetAddress address;
        try {
            address = InetAddress.getByName(host);
        } catch (UnknownHostException e) {
            throw new UnknownHostException("expected the name or number of an address of this computer, found " + Quote.of(host));
        }
        if (!address.isLoopbackAddress() && tls.isEmpty()) {
            throw new UnknownHostException(
                    Quote.of(host)
                            + ": an address for other computers needs a certificate; create one with 'lightning node --make-certificate'");
        }
        return new InetSocketAddress(address, port);
    }
}
