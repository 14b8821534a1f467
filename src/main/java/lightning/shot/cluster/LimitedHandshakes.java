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

/** TLS whose handshakes end after some silence of the peer: JGroups waits without a limit, with a lock held that others need. */
final class LimitedHandshakes extends TLS {
    private final SSLContext context;
    private final int patience;

    /** @param patience milliseconds that a peer may be silent during a handshake */
    LimitedHandshakes(SSLContext context, int patience) {
        this.context = context;
        this.patience = patience;
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
                return new HandshakeServerSocket(context, parameters, patience);
            }
        };
    }

    private void limit(SSLSocket socket) throws SocketException {
        socket.setSoTimeout(patience);
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
