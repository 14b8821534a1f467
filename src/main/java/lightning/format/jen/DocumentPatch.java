package lightning.format.jen;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.shot.Shot;
import lightning.scene.shot.TrackRetargeting;

/**
 * Minimal text edits that update a valid scene file to an edited scene.
 *
 * <p>A block matches an element with the same name and type. An unmatched block and an unmatched element at the same
 * position in their lists (from the front or the back) are treated as renamed. Reordered blocks are swapped in place.
 */
record DocumentPatch(SourceText source, TokenList tokens, Set<LeftOutFile> leftOut) {
    private static final int VERSION_TOKEN = 1;

    /**
     * Returns the patched text.
     *
     * @param original scene that {@code text} describes; elements identical in {@code edited} are skipped
     * @param leftOut files that the scene lacks; the text still names them
     */
    static String apply(String text, Scene original, Scene edited, Set<LeftOutFile> leftOut) {
        var problems = new ProblemList();
        TokenList tokens = Lexer.tokens(text, problems);
        List<Block> blocks = Parser.parseFile(tokens, problems);
        return new DocumentPatch(new SourceText("", text), tokens, leftOut).patchScene(blocks, original, edited);
    }

    /** Returns the text with a replaced shot block, appended if there was none. */
    static String applyShot(String text, Scene scene, Shot shot) {
        TokenList tokens = Lexer.tokens(text, new ProblemList());
        var source = new SourceText("", text);
        String block = new ShotWriter(scene, source.newline()).block(shot);
        Optional<Block> old = Parser.parseFile(tokens, new ProblemList()).stream().filter(b -> b.type == BlockTypes.SHOT).findFirst();
        if (old.isPresent()) {
            return text.substring(0, tokens.start(old.get().keywordToken)) + block + text.substring(tokens.end(old.get().closeToken));
        }
        return text + (text.endsWith("\n") ? "" : source.newline()) + source.newline() + block + source.newline();
    }

    /** Returns the text without its shot block. */
    static String removeShot(String text) {
        TokenList tokens = Lexer.tokens(text, new ProblemList());
        var edits = new TextEdits(text);
        var patch = new DocumentPatch(new SourceText("", text), tokens, Set.of());
        SceneBuilder.blocksOfType(Parser.parseFile(tokens, new ProblemList()), BlockTypes.SHOT).forEach(shot -> patch.remove(edits, shot));
        return edits.apply(0, text.length());
    }

    /** Updates the animated blocks: renames follow, deleted targets are removed. */
    private void patchShot(TextEdits edits, Block shot, Scene original, Scene edited) {
        var succession = new TrackRetargeting(original, edited);
        for (Block child : shot.children) {
            SceneElement<?> updatedTarget = succession.retarget(ShotBuilder.target(child)).orElse(null);
            if (updatedTarget == null) {
                remove(edits, child);
                continue;
            }
            String head = new ShotWriter(edited, source.newline()).header(updatedTarget);
            if (BlockTypes.of(edited, updatedTarget) != child.type || !updatedTarget.name().equals(child.name)) {
                edits.replace(start(child), tokens.end(child.nameToken), head);
            }
            List<String> attributes = updatedTarget.attributes(edited).stream().map(SceneAttribute::name).toList();
            child.keys.stream().filter(k -> !attributes.contains(k.property().name()))
                    .forEach(k -> remove(edits, k.nameToken(), k.closeToken()));
        }
    }

    private String patchScene(List<Block> blocks, Scene original, Scene edited) {
        var edits = new TextEdits(source.text());
        patchSingle(edits, blocks, BlockContent.of(BlockTypes.PICTURE, edited.picture()));
        patchSingle(edits, blocks, BlockContent.of(BlockTypes.CAMERA, edited.camera()));
        patchSingle(edits, blocks, BlockContent.of(BlockTypes.WORLD, edited.world()));
        List<BlockContent> added = new ArrayList<>();
        if (!edited.materials().equals(original.materials())) {
            added.addAll(patchList(edits, SceneBuilder.blocksOfType(blocks, BlockTypes.MATERIAL),
                    edited.materials().stream().map(BlockContent::of).toList()));
        }
        if (!edited.nodes().equals(original.nodes())) {
            added.addAll(
                    patchList(edits, SceneBuilder.nodeBlocks(blocks), edited.nodes().stream().map(BlockContent::of).toList()));
        }
        added.addAll(patchList(edits, SceneBuilder.blocksOfType(blocks, BlockTypes.NAMED_CAMERA),
                edited.cameras().stream().map(BlockContent::of).toList()));
        added.addAll(patchList(edits, SceneBuilder.blocksOfType(blocks, BlockTypes.DOME),
                edited.world().named().stream().map(BlockContent::of).toList()));
        added.addAll(patchList(edits, SceneBuilder.blocksOfType(blocks, BlockTypes.LIGHT_GROUP),
                edited.rig().lightGroups().stream().map(BlockContent::of).toList()));
        added.addAll(patchList(edits, SceneBuilder.blocksOfType(blocks, BlockTypes.LIGHT),
                edited.lights().stream().map(BlockContent::of).toList()));
        SceneBuilder.blocksOfType(blocks, BlockTypes.SHOT).forEach(shot -> patchShot(edits, shot, original, edited));
        var out = new StringBuilder(edits.apply(0, source.text().length()));
        for (BlockContent element : added) {
            if (out.charAt(out.length() - 1) != '\n') {
                out.append(source.newline());
            }
            out.append(JenWriter.block(element, "", source.newline())).append(source.newline());
        }
        return out.toString();
    }

    private void patchSingle(TextEdits edits, List<Block> blocks, BlockContent target) {
        List<Block> old = SceneBuilder.blocksOfType(blocks, target.type());
        if (!old.isEmpty()) {
            new BlockPatch(source, tokens, edits, leftOut).apply(old.getFirst(), target);
        } else if (!target.isInitial()) {
            String block = source.newline() + JenWriter.block(target, "", source.newline());
            int end = tokens.end(VERSION_TOKEN);
            int lineEnd = source.lineEnd(end);
            boolean isLastInLine = tokens.start(VERSION_TOKEN + 1) >= lineEnd;
            edits.insert(isLastInLine ? lineEnd : end, isLastInLine ? block : block + source.newline());
        }
    }

    /** Patches the blocks of one list with a common parent; returns the elements to append. */
    private List<BlockContent> patchList(TextEdits edits, List<Block> old, List<BlockContent> target) {
        Map<BlockContent, Block> matches = match(old, target);
        List<Block> slots = matches.values().stream().sorted(Comparator.comparingInt(b -> b.keywordToken)).toList();
        Set<Block> matched = new HashSet<>(slots);
        old.stream().filter(b -> !matched.contains(b)).forEach(b -> remove(edits, b));
        List<BlockContent> added = new ArrayList<>();
        int next = 0;
        for (BlockContent element : target) {
            Block block = matches.get(element);
            if (block == null) {
                added.add(element);
                continue;
            }
            Block slot = slots.get(next++);
            insertBefore(edits, slot, added);
            added.clear();
            if (block == slot) {
                patchBlock(edits, block, element);
            } else {
                var innerEdits = new TextEdits(source.text());
                patchBlock(innerEdits, block, element);
                edits.replace(start(slot), end(slot), innerEdits.apply(start(block), end(block)));
            }
        }
        return added;
    }

    private void patchBlock(TextEdits edits, Block block, BlockContent target) {
        new BlockPatch(source, tokens, edits, leftOut).apply(block, target);
        if (block.type == BlockTypes.GROUP) {
            append(edits, block, patchList(edits, block.children, target.children()));
        }
    }

    private static Map<BlockContent, Block> match(List<Block> old, List<BlockContent> target) {
        Map<String, Block> unmatched = new HashMap<>();
        old.forEach(b -> unmatched.put(b.name, b));
        Map<BlockContent, Block> matches = new IdentityHashMap<>();
        for (BlockContent element : target) {
            Block block = unmatched.get(element.name());
            if (block != null && block.type == element.type()) {
                matches.put(element, unmatched.remove(element.name()));
            }
        }
        for (int i = 0; i < target.size(); i++) {
            BlockContent element = target.get(i);
            for (int j : new int[] {i, i + old.size() - target.size()}) {
                if (j >= 0 && j < old.size() && !matches.containsKey(element) && old.get(j).type == element.type()
                        && unmatched.remove(old.get(j).name, old.get(j))) {
                    matches.put(element, old.get(j));
                }
            }
        }
        return matches;
    }

    private void insertBefore(TextEdits edits, Block nextBlock, List<BlockContent> added) {
        String indent = source.indent(start(nextBlock));
        for (BlockContent element : added) {
            String block = JenWriter.block(element, indent, source.newline()).substring(indent.length());
            edits.insert(start(nextBlock), block + source.newline() + indent);
        }
    }

    /** Inserts new children before the closing brace of a group. */
    private void append(TextEdits edits, Block group, List<BlockContent> added) {
        int close = tokens.start(group.closeToken);
        String outer = source.indent(start(group));
        boolean isOnOwnLine = source.text().substring(source.lineStart(close), close).isBlank();
        for (BlockContent element : added) {
            String block = JenWriter.block(element, outer + "  ", source.newline());
            edits.insert(isOnOwnLine ? source.lineStart(close) : close,
                    isOnOwnLine ? block + source.newline() : source.newline() + block);
        }
        if (!added.isEmpty() && !isOnOwnLine) {
            edits.insert(close, source.newline() + outer);
        }
    }

    /** Removes a block, including its lines if they contain nothing else. */
    private void remove(TextEdits edits, Block block) {
        remove(edits, block.keywordToken, block.closeToken);
    }

    /** Removes a range of tokens, including its lines if they contain nothing else. */
    private void remove(TextEdits edits, int first, int last) {
        int start = tokens.start(first);
        int end = tokens.end(last);
        int from = source.lineStart(start);
        int to = source.lineEnd(end);
        String text = source.text();
        if (text.substring(from, start).isBlank() && text.substring(end, to).isBlank()) {
            edits.replace(from, Math.min(text.length(), to == text.length() ? to : text.indexOf('\n', to) + 1), "");
        } else {
            edits.replace(start, end, "");
        }
    }

    private int start(Block block) {
        return tokens.start(block.keywordToken);
    }

    private int end(Block block) {
        return tokens.end(block.closeToken);
    }
}
