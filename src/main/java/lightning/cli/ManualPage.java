package lightning.cli;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.text.ReleaseInfo;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** Manual page of a command in the format of {@code man}, from the same descriptions as its help. */
final class ManualPage {
    private final CommandSpec command;

    ManualPage(CommandLine command) {
        this.command = command.getCommandSpec();
    }

    /** Returns the name of the page and of its file, such as {@code lightning-shot-render}. */
    private static String name(CommandSpec command) {
        return command.qualifiedName("-");
    }

    String fileName() {
        return name(command) + ".1";
    }

    /** Returns the page as roff. */
    String text() {
        var usage = command.usageMessage();
        var out = new StringBuilder();
        out.append(".TH \"").append(name(command).toUpperCase(Locale.ROOT)).append("\" \"1\" \"\" \"Lightning ")
                .append(escape(ReleaseInfo.number())).append("\" \"Lightning\"\n.nh\n.ad l\n");
        section(out, "Name", List.of(name(command) + " \\- " + lower(line(String.join(" ", usage.header())))));
        section(out, "Synopsis", List.of("\\fB" + escape(command.qualifiedName()) + "\\fR " + synopsis()));
        section(out, "Description", Stream.of(usage.description()).map(ManualPage::line).toList());
        arguments(out, "Arguments", command.positionalParameters());
        arguments(out, "Options", command.options().stream().filter(option -> !option.hidden()).toList());
        commands(out);
        footer(out, Stream.of(usage.footer()).map(text -> format(text)).toList());
        return out.toString();
    }

    private String synopsis() {
        return Stream.of("[\\fIOPTIONS\\fR]", command.positionalParameters().stream().map(p -> "\\fI" + escape(p.paramLabel()) + "\\fR")
                .collect(Collectors.joining(" ")), command.subcommands().isEmpty() ? "" : "[\\fICOMMAND\\fR]")
                .filter(part -> !part.isEmpty()).collect(Collectors.joining(" "));
    }

    private static void section(StringBuilder out, String title, List<String> paragraphs) {
        out.append(".SH ").append(title.toUpperCase(Locale.ROOT)).append('\n');
        String joint = "";
        for (String paragraph : paragraphs) {
            if (!paragraph.isEmpty()) {
                out.append(joint).append(paragraph).append('\n');
                joint = ".PP\n";
            }
        }
    }

    private static void arguments(StringBuilder out, String title, List<? extends ArgSpec> arguments) {
        if (arguments.isEmpty()) {
            return;
        }
        out.append(".SH ").append(title.toUpperCase(Locale.ROOT)).append('\n');
        for (ArgSpec argument : arguments) {
            out.append(".TP\n").append(label(argument)).append('\n')
                    .append(Stream.of(argument.description()).map(ManualPage::line).collect(Collectors.joining("\n.br\n")))
                    .append('\n');
        }
    }

    private static String label(ArgSpec argument) {
        String value = "\\fI" + escape(argument.paramLabel()) + "\\fR";
        if (argument instanceof OptionSpec option) {
            boolean takesValue = option.arity().max() > 0;
            return Stream.of(option.names()).map(name -> "\\fB" + escape(name) + "\\fR").collect(Collectors.joining(", "))
                    + (takesValue ? "=" + value : "");
        }
        return value;
    }

    private void commands(StringBuilder out) {
        if (!command.subcommands().isEmpty()) {
            out.append(".SH COMMANDS\n");
            command.subcommands().values().stream().map(CommandLine::getCommandSpec).forEach(next -> out.append(".TP\n\\fB")
                    .append(escape(name(next))).append("\\fR(1)\n").append(line(String.join(" ", next.usageMessage().header())))
                    .append('\n'));
        }
    }

    /** Writes the examples unfilled, and the texts before them. */
    private static void footer(StringBuilder out, List<String> lines) {
        if (lines.isEmpty()) {
            return;
        }
        int examples = 0;
        while (examples < lines.size() && !lines.get(examples).startsWith("Example")) {
            examples++;
        }
        if (examples > 0) {
            section(out, "Exit status", lines.subList(0, examples).stream().map(ManualPage::escape).toList());
        }
        if (examples < lines.size()) {
            out.append(".SH EXAMPLES\n.nf\n");
            lines.subList(examples + 1, lines.size()).forEach(line -> out.append(escape(line.strip())).append('\n'));
            out.append(".fi\n");
        }
    }

    /** Expands picocli's format, in which a percent sign is written twice. */
    private static String format(String text) {
        return Ansi.OFF.string(text.replace("%n", "\n").replace("%%", "%"));
    }

    private static String line(String text) {
        return escape(format(text));
    }

    private static String lower(String text) {
        String sentence = text.endsWith(".") ? text.substring(0, text.length() - 1) : text;
        return sentence.isEmpty() ? sentence : sentence.substring(0, 1).toLowerCase(Locale.ROOT) + sentence.substring(1);
    }

    /** Escapes roff's characters: the backslash, hyphens, and a dot or quote at the start of a line. */
    private static String escape(String text) {
        String escaped = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq");
        return escaped.startsWith(".") ? "\\&" + escaped : escaped;
    }
}
