package lightning.cluster;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.util.concurrent.ThreadLocalRandom;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLServerSocket;
import javax.net.ssl.SSLSocket;
import org.jgroups.util.DefaultSocketFactory;
import org.jgroups.util.SocketFactory;
import org.jgroups.util.TLS;

/**
 * TLS whose handshakes end after some time. JGroups connects while it holds the lock that it needs to accept: two members that connect to
 * each other at the same moment would wait for each other for ever. Each gives up after a time of its own, and one is first.
 */
final class LimitedHandshakes extends TLS {
    private static final int SHORTEST_MILLISECONDS = 1500;
    private static final int LONGEST_MILLISECONDS = 4000;

    private final SSLContext context;

    LimitedHandshakes(SSLContext context) {
        this.context = context;
        enabled(true);
        setSSLContext(context);
    }

    @Override
    public SocketFactory createSocketFactory() {
        var parameters = new SSLParameters();
        parameters.setProtocols(new String[] {"TLSv1.3"});
        parameters.setNeedClientAuth(true);
        var factory = new DefaultSocketFactory(context) {
            @Override
            public Socket createSocket(String name) throws IOException {
                SSLSocket socket = (SSLSocket) super.createSocket(name);
                limit(socket);
                return socket;
            }
        };
        factory.setServerSocketConfigurator(socket -> ((SSLServerSocket) socket).setSSLParameters(parameters));
        return factory;
    }

    private static void limit(SSLSocket socket) throws SocketException {
        socket.setSoTimeout(ThreadLocalRandom.current().nextInt(SHORTEST_MILLISECONDS, LONGEST_MILLISECONDS));
        socket.addHandshakeCompletedListener(_ -> {
            try {
                // From here on silence is no fault.
                socket.setSoTimeout(0);
            } catch (SocketException e) {
                // Closed meanwhile.
            }
        });
    }
}
