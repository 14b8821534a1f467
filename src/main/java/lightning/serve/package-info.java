/**
 * Server that keeps scenes loaded and answers requests of other programs: JSON, one message a line ({@code docs/serve.md}).
 * Commands with options and printed results belong to {@code cli}.
 *
 * <pre>{@code
 * try (Server server = new Server(ServerOptions.DEFAULT)) {
 *     server.connect(System.in, System.out, server::stop);
 *     server.awaitStop();
 * }
 * }</pre>
 *
 * <p>Each {@link lightning.serve.Client} has a thread that reads requests and one that writes answers. Each {@link
 * lightning.serve.SceneSession} has a thread that runs its requests in order. Pictures of all scenes are traced one after the other,
 * each on all processors. A request that fails changes nothing.
 */
@NullMarked
package lightning.serve;

import org.jspecify.annotations.NullMarked;
