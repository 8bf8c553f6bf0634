/* _dl_find_object for musl, which has dl_iterate_phdr alone: libgcc of Debian, made for glibc, asks
   with it where the unwinding tables of an address are. The structure is glibc's (dlfcn.h). */
#define _GNU_SOURCE
#include <link.h>
#include <stdint.h>

struct dl_find_object {
  unsigned long long flags;
  void *map_start, *map_end;
  struct link_map* link_map;
  void* eh_frame;
  unsigned long long reserved[7];
};

struct search {
  uintptr_t address;
  struct dl_find_object* result;
};

static int look(struct dl_phdr_info* object, size_t size, void* data) {
  const struct search* search = data;
  const uintptr_t base = object->dlpi_addr;
  void* tables = 0;
  int found = 0;
  (void)size;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)* part = &object->dlpi_phdr[i];
    const uintptr_t begin = base + part->p_vaddr;
    if (part->p_type == PT_GNU_EH_FRAME) tables = (void*)begin;
    if (part->p_type != PT_LOAD || search->address - begin >= part->p_memsz) continue;
    search->result->map_start = (void*)begin;
    search->result->map_end = (void*)(begin + part->p_memsz);
    found = 1;
  }
  search->result->eh_frame = tables;
  return found && tables;
}

/* 0 where the object that holds `address` is found. */
int _dl_find_object(void* address, struct dl_find_object* result) {
  struct search search = {(uintptr_t)address, result};
  *result = (struct dl_find_object){0};
  return dl_iterate_phdr(look, &search) ? 0 : -1;
}
