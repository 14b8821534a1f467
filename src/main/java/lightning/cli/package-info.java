/**
 * The command line: each command is a class, {@link lightning.cli.Lightning} runs them.
 *
 * <pre>{@code
 * int exit = Lightning.run(System.out, System.err, "render", "scenes/bird.jen", "-o", "bird.png");
 * }</pre>
 *
 * <p>Rules of all commands: results go to the output, complaints to the errors; the exit code is 0 when the work is
 * done, 1 when a check failed, 2 for bad usage or bad input, 130 when canceled. No stack trace reaches a user, numbers
 * look the same in every locale, and files appear whole or not at all. Interrupting the thread that runs a command
 * cancels it.
 */
package lightning.cli;
