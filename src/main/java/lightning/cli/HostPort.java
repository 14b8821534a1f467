package lightning.cli;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.cluster.Place;
import lightning.text.Quote;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Where a member of a cluster is heard: {@code render7:7800}, {@code 10.0.0.7}, {@code [::1]:7800}. */
record HostPort(String host, int port) {
    private static final int LAST_PORT = 65_535;

    /** @throws BadInput if there is no such machine */
    InetSocketAddress address() throws BadInput {
        return new InetSocketAddress(address(host), port);
    }

    static InetAddress address(String host) throws BadInput {
        try {
            return InetAddress.getByName(host);
        } catch (UnknownHostException e) {
            throw new BadInput("there is no machine " + Quote.of(host) + " that this one knows of");
        }
    }

    /** Reads what a person typed. */
    static final class Converter implements ITypeConverter<HostPort> {
        private static final Pattern WORDS = Pattern.compile("(?:\\[([0-9a-fA-F:.%]{1,100})]|([^:\\[\\]\\s]{1,255}))(?::([0-9]{1,5}))?");

        @Override
        public HostPort convert(String text) {
            Matcher words = WORDS.matcher(text);
            int port = words.matches() && words.group(3) != null ? Integer.parseInt(words.group(3)) : Place.NODE_PORT;
            if (!words.matches() || port < 1 || port > LAST_PORT) {
                throw new TypeConversionException("expected a machine and a port from 1 to " + LAST_PORT + " as in render7:7800, found "
                        + Quote.of(text));
            }
            return new HostPort(words.group(1) == null ? words.group(2) : words.group(1), port);
        }
    }
}
