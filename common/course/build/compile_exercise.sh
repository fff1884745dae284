#!/bin/sh
# A student's file, with the whole command of the compiler as arguments (... -o OBJECT -c FILE): where it does not
# compile it becomes an empty object, and what the compiler said becomes OBJECT.error. Always ends with 0, so that the
# rest of the course is built. A compiler that fails twice without a line of the file was ended by the machine (memory, a
# full disc): that becomes OBJECT.ended, and ./course check has it compiled again.
export LC_ALL=C
object='' last=''
for word; do
    [ "$last" = -o ] && object=$word
    last=$word
done
names_a_line() {
    printf '%s\n' "$said" | grep -Eq '^[^:]+:[0-9]+(:[0-9]+)?: (fatal )?error: '
}
if said=$("$@" 2>&1) || { ! names_a_line && said=$("$@" 2>&1); }; then
    rm -f "$object.error" "$object.ended"
    [ -z "$said" ] || printf '%s\n' "$said"
    exit 0
fi
printf '%s\n' "$said"
if names_a_line; then
    printf '%s\n' "$said" >"$object.error"
    rm -f "$object.ended"
else
    printf '%s\n' "$said" >"$object.ended"
    rm -f "$object.error"
fi
: >"$object.empty.cpp"
left=$#
for word; do  # the same command, with another file at its end
    shift
    left=$((left - 1))
    [ "$left" = 0 ] && word=$object.empty.cpp
    set -- "$@" "$word"
done
exec "$@"
