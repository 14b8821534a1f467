/**
 * Command line: each command is a class, {@link lightning.cli.Lightning} runs them.
 * A command reads its options, calls another group and prints; it computes nothing itself.
 *
 * <pre>{@code
 * int exit = Lightning.run(System.out, System.err, "render", "scenes/bird.jen", "-o", "bird.png");
 * }</pre>
 *
 * <p>All commands print results to the output and errors to the error stream. The exit code is 0 when done, 1 when a check
 * failed, 2 for bad usage or bad input, 130 when canceled. Users see no stack trace, numbers are locale-independent, and
 * files appear complete or not at all. Interrupting the thread that runs a command cancels it.
 */
@NullMarked
package lightning.cli;

import org.jspecify.annotations.NullMarked;
