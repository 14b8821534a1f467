package lightning.shot.cluster;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;

/** Address of a cluster member: {@code render7:7800}, {@code 10.0.0.7}, {@code [::1]:7800}. */
public record HostPort(String host, int port) {
    private static final Pattern PATTERN = Pattern.compile("(?:\\[([0-9a-fA-F:.%]{1,100})]|([^:,\\[\\]\\s]{1,255}))(?::([0-9]{1,5}))?");
    private static final int MAX_PORT = 65_535;

    /**
     * Parses user input; the default port is {@link NodeConfig#NODE_PORT}.
     *
     * @throws RefusalException if it is not a valid address; the message is a sentence
     */
    public static HostPort parse(String text) {
        Matcher matcher = PATTERN.matcher(text);
        int port = matcher.matches() && matcher.group(3) != null ? Integer.parseInt(matcher.group(3)) : NodeConfig.NODE_PORT;
        if (!matcher.matches() || port < 1 || port > MAX_PORT) {
            throw new RefusalException(
                    Messages.tr("expected a host and a port from 1 to {0}, such as render7:7800, found {1}", MAX_PORT, Quote.of(text)));
        }
        return new HostPort(matcher.group(1) == null ? matcher.group(2) : matcher.group(1), port);
    }

    /**
     * Parses a comma-separated list with at least one address.
     *
     * @throws RefusalException as {@link #parse}
     */
    public static List<HostPort> parseAll(String text) {
        List<HostPort> result = new ArrayList<>();
        for (String part : text.split(",", -1)) {
            result.add(parse(part.strip()));
        }
        return result;
    }

    /**
     * Resolves the address; may query a name server and wait for it.
     *
     * @throws JoinException if the host is unknown
     */
    public InetSocketAddress address() throws JoinException {
        return new InetSocketAddress(address(host), port);
    }

    /** Returns the text that a user would type: {@code render7:7800}, {@code 10.0.0.7:7800}, {@code [::1]:7800}. */
    public String format() {
        return (host.contains(":") ? "[" + host + "]" : host) + ":" + port;
    }

    /** Resolves a host name; may query a name server and wait for it. */
    public static InetAddress address(String host) throws JoinException {
        try {
            return InetAddress.getByName(host);
        } catch (UnknownHostException e) {
            throw new JoinException(Messages.tr("unknown host {0}", Quote.of(host)), e);
        }
    }
}
