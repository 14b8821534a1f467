package lightning.editor.window;

import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.CaseTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreeScanner;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;

/**
 * Texts that the program's source passes to {@code Messages}.
 *
 * @param used English texts
 * @param literals literals in the editor's panes that look like text but are not passed to {@code Messages}, with their positions
 */
record UiTextScan(Set<String> used, List<String> literals) {
    private static final Path MAIN = Path.of("src", "main", "java", "lightning");
    /** Matches text that starts like a sentence or title, or contains two lowercase words. */
    private static final Pattern WORDS = Pattern.compile("(?s)[A-Z][a-z]{2,}.*|.*[a-z]{3,} [a-z]{2,}.*");
    /** Calls whose arguments are never shown: styles, ids, names of files and threads, internal errors. */
    private static final Set<String> IGNORED_CALLS = Set.of("setStyle", "setId", "add", "addAll", "web", "startsWith", "replaceFirst",
            "getLogger", "store", "matches", "endsWith");

    static UiTextScan read() throws IOException {
        var usedTexts = new TreeSet<String>();
        var literals = new ArrayList<String>();
        var compiler = ToolProvider.getSystemJavaCompiler();
        try (var files = Files.walk(MAIN); var manager = compiler.getStandardFileManager(null, null, null)) {
            List<Path> sources = files.filter(f -> f.toString().endsWith(".java")).sorted().toList();
            var task = (JavacTask) compiler.getTask(null, manager, null, List.of("-proc:none"), null,
                    manager.getJavaFileObjectsFromPaths(sources));
            for (CompilationUnitTree unit : task.parse()) {
                boolean ofPanes = unit.getPackageName().toString().startsWith("lightning.editor.window");
                unit.accept(new Scanner(usedTexts, ofPanes ? literals : new ArrayList<>()), null);
            }
        }
        return new UiTextScan(usedTexts, literals);
    }

    private static final class Scanner extends TreeScanner<Void, Void> {
        private final Set<String> usedTexts;
        private final List<String> literals;
        private boolean unseen;

        Scanner(Set<String> usedTexts, List<String> literals) {
            this.usedTexts = usedTexts;
            this.literals = literals;
        }

        @Override
        public Void visitMethodInvocation(MethodInvocationTree call, Void none) {
            String name = call.getMethodSelect().toString();
            if (name.startsWith("Messages.")) {
                call.getArguments().stream().limit(name.equals("Messages.count") ? 3 : 1).forEach(words -> {
                    if (isText(words)) {
                        usedTexts.add(text(words));
                    }
                });
                call.getArguments().stream().filter(words -> !isText(words)).forEach(words -> scan(words, none));
                return null;
            }
            boolean hides = IGNORED_CALLS.contains(name.substring(name.lastIndexOf('.') + 1));
            return hidden(hides, () -> super.visitMethodInvocation(call, none));
        }

        @Override
        public Void visitNewClass(NewClassTree made, Void none) {
            String type = made.getIdentifier().toString();
            boolean hides = type.endsWith("Exception") || type.equals("DataFormat") || type.equals("ExtensionFilter");
            return hidden(hides, () -> super.visitNewClass(made, none));
        }

        private Void hidden(boolean hides, Runnable scan) {
            boolean before = unseen;
            unseen |= hides;
            scan.run();
            unseen = before;
            return null;
        }

        @Override
        public Void visitCase(CaseTree one, Void none) {
            return scan(one.getBody() == null ? one.getStatements() : List.of(one.getBody()), none);
        }

        @Override
        public Void visitLiteral(LiteralTree literal, Void none) {
            if (!unseen && literal.getValue() instanceof String text && WORDS.matcher(text).matches()) {
                literals.add(text);
            }
            return null;
        }

        private static boolean isText(Tree tree) {
            return tree instanceof LiteralTree literal && literal.getValue() instanceof String
                    || tree instanceof BinaryTree both && isText(both.getLeftOperand()) && isText(both.getRightOperand());
        }

        private static String text(Tree tree) {
            return tree instanceof BinaryTree both ? text(both.getLeftOperand()) + text(both.getRightOperand())
                    : (String) ((LiteralTree) tree).getValue();
        }
    }
}
