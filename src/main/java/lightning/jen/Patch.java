package lightning.jen;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.scene.Scene;

/**
 * Brings the text of a valid scene file to an edited scene by the fewest changes.
 *
 * <p>A block and an element are the same when they have one name and one type; of those left over, a
 * block and an element at the same place in their lists (from the front or from the back) are one
 * that was renamed. Blocks whose order changed are put into each other's places.
 */
final class Patch {
    private static final int VERSION_TOKEN = 1;

    private final Source source;
    private final Tokens tokens;

    private Patch(Source source, Tokens tokens) {
        this.source = source;
        this.tokens = tokens;
    }

    /**
     * The patched text.
     *
     * @param before what {@code text} reads as: what is the same in {@code edited} is not looked at
     */
    static String apply(String text, Scene before, Scene edited) {
        var problems = new Problems();
        Tokens tokens = Lexer.tokens(text, problems);
        List<Block> blocks = Parser.file(tokens, problems);
        return new Patch(new Source("", text), tokens).scene(blocks, before, edited);
    }

    private String scene(List<Block> blocks, Scene before, Scene edited) {
        var edits = new Edits(source.text());
        single(edits, blocks, Element.of(Blocks.PICTURE, edited.picture()));
        single(edits, blocks, Element.of(Blocks.CAMERA, edited.camera()));
        single(edits, blocks, Element.of(Blocks.WORLD, edited.world()));
        List<Element> added = new ArrayList<>();
        if (!edited.materials().equals(before.materials())) {
            added.addAll(list(edits, ofKinds(blocks, List.of(Blocks.MATERIAL.keyword())),
                    edited.materials().stream().map(Element::of).toList()));
        }
        if (!edited.nodes().equals(before.nodes())) {
            added.addAll(list(edits, ofKinds(blocks, Blocks.NODES), edited.nodes().stream().map(Element::of).toList()));
        }
        added.addAll(list(edits, ofKinds(blocks, List.of(Blocks.BANK.keyword())),
                edited.rig().banks().stream().map(Element::of).toList()));
        added.addAll(list(edits, ofKinds(blocks, List.of(Blocks.LIGHT.keyword())),
                edited.lights().stream().map(Element::of).toList()));
        var out = new StringBuilder(edits.apply(0, source.text().length()));
        for (Element element : added) {
            if (out.charAt(out.length() - 1) != '\n') {
                out.append(source.newline());
            }
            out.append(JenWriter.block(element, "", source.newline())).append(source.newline());
        }
        return out.toString();
    }

    private static List<Block> ofKinds(List<Block> blocks, List<String> keywords) {
        return blocks.stream().filter(b -> keywords.contains(b.type.keyword())).toList();
    }

    private void single(Edits edits, List<Block> blocks, Element wanted) {
        List<Block> old = ofKinds(blocks, List.of(wanted.type().keyword()));
        if (!old.isEmpty()) {
            new BlockPatch(source, tokens, edits).apply(old.getFirst(), wanted);
        } else if (!wanted.isInitial()) {
            String block = source.newline() + JenWriter.block(wanted, "", source.newline());
            int end = tokens.end(VERSION_TOKEN);
            int lineEnd = source.lineEnd(end);
            boolean lastInLine = tokens.start(VERSION_TOKEN + 1) >= lineEnd;
            edits.insert(lastInLine ? lineEnd : end, lastInLine ? block : block + source.newline());
        }
    }

    /** Patches the blocks of one list, all in one parent; returns the elements to add behind the last. */
    private List<Element> list(Edits edits, List<Block> old, List<Element> wanted) {
        Map<Element, Block> same = match(old, wanted);
        List<Block> places = same.values().stream().sorted(Comparator.comparingInt(b -> b.keyword)).toList();
        Set<Block> kept = new HashSet<>(places);
        old.stream().filter(b -> !kept.contains(b)).forEach(b -> cut(edits, b));
        List<Element> added = new ArrayList<>();
        int next = 0;
        for (Element element : wanted) {
            Block block = same.get(element);
            if (block == null) {
                added.add(element);
                continue;
            }
            Block place = places.get(next++);
            insertBefore(edits, place, added);
            added.clear();
            if (block == place) {
                patch(edits, block, element);
            } else {
                var inside = new Edits(source.text());
                patch(inside, block, element);
                edits.replace(start(place), end(place), inside.apply(start(block), end(block)));
            }
        }
        return added;
    }

    private void patch(Edits edits, Block block, Element wanted) {
        new BlockPatch(source, tokens, edits).apply(block, wanted);
        if (block.type == Blocks.GROUP) {
            append(edits, block, list(edits, block.children, wanted.children()));
        }
    }

    private static Map<Element, Block> match(List<Block> old, List<Element> wanted) {
        Map<String, Block> left = new HashMap<>();
        old.forEach(b -> left.put(b.name, b));
        Map<Element, Block> same = new IdentityHashMap<>();
        for (Element element : wanted) {
            Block block = left.get(element.name());
            if (block != null && block.type == element.type()) {
                same.put(element, left.remove(element.name()));
            }
        }
        for (int i = 0; i < wanted.size(); i++) {
            Element element = wanted.get(i);
            for (int j : new int[] {i, i + old.size() - wanted.size()}) {
                if (j >= 0 && j < old.size() && !same.containsKey(element) && old.get(j).type == element.type()
                        && left.remove(old.get(j).name, old.get(j))) {
                    same.put(element, old.get(j));
                }
            }
        }
        return same;
    }

    private void insertBefore(Edits edits, Block place, List<Element> added) {
        String indent = source.indent(start(place));
        for (Element element : added) {
            String block = JenWriter.block(element, indent, source.newline()).substring(indent.length());
            edits.insert(start(place), block + source.newline() + indent);
        }
    }

    /** Puts new children before the closing brace of a group. */
    private void append(Edits edits, Block group, List<Element> added) {
        int close = tokens.start(group.close);
        String outer = source.indent(start(group));
        boolean ownLine = source.text().substring(source.lineStart(close), close).isBlank();
        for (Element element : added) {
            String block = JenWriter.block(element, outer + "  ", source.newline());
            edits.insert(ownLine ? source.lineStart(close) : close,
                    ownLine ? block + source.newline() : source.newline() + block);
        }
        if (!added.isEmpty() && !ownLine) {
            edits.insert(close, source.newline() + outer);
        }
    }

    /** Cuts out a block, with its lines where nothing else is in them. */
    private void cut(Edits edits, Block block) {
        int from = source.lineStart(start(block));
        int to = source.lineEnd(end(block));
        String text = source.text();
        if (text.substring(from, start(block)).isBlank() && text.substring(end(block), to).isBlank()) {
            edits.replace(from, Math.min(text.length(), to == text.length() ? to : text.indexOf('\n', to) + 1), "");
        } else {
            edits.replace(start(block), end(block), "");
        }
    }

    private int start(Block block) {
        return tokens.start(block.keyword);
    }

    private int end(Block block) {
        return tokens.end(block.close);
    }
}
