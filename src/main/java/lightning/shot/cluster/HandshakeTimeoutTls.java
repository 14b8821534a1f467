package lightning.shot.cluster;

import java.io.IOException;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLSocket;
import org.jgroups.util.DefaultSocketFactory;
import org.jgroups.util.SocketFactory;
import org.jgroups.util.TLS;

/** TLS with a timeout for handshakes: JGroups waits without a limit, holding a lock that other connections need. */
final class HandshakeTimeoutTls extends TLS {
    private final SSLContext context;
    private final int timeoutMillis;

    /** @param timeoutMillis maximum silence of a peer during a handshake, milliseconds */
    HandshakeTimeoutTls(SSLContext context, int timeoutMillis) {
        this.context = context;
        this.timeoutMillis = timeoutMillis;
        enabled(true);
        setSSLContext(context);
    }

    @Override
    public SocketFactory createSocketFactory() {
        var parameters = new SSLParameters();
        parameters.setProtocols(new String[] {"TLSv1.3"});
        parameters.setNeedClientAuth(true);
        return new DefaultSocketFactory(context) {
            @Override
            public Socket createSocket(String name) throws IOException {
                SSLSocket socket = (SSLSocket) super.createSocket(name);
                limit(socket);
                return socket;
            }

            @Override
            public ServerSocket createServerSocket(String name) throws IOException {
                return new HandshakeServerSocket(context, parameters, timeoutMillis);
            }
        };
    }

    private void limit(SSLSocket socket) throws SocketException {
        socket.setSoTimeout(timeoutMillis);
        socket.addHandshakeCompletedListener(_ -> {
            try {
                // After the handshake, silence is normal.
                socket.setSoTimeout(0);
            } catch (SocketException e) {
                // Closed meanwhile.
            }
        });
    }
}
